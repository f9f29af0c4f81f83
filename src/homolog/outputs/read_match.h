// SPDX-License-Identifier: MIT
// match.json and the parts.json beside it, read again: the twin of match_json.h and parts.h.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "homolog/homolog.h"
#include "homolog/match/symmetry.h"
#include "homolog/match/transfer.h"

namespace homolog {

struct StoredShape {
  std::string file;
  bool ras = false;          ///< Mesh::ras
  std::size_t vertices = 0;  ///< of the mesh that was matched; known if the parts are
};

/// What later steps need.
struct StoredFamily {
  StoredShape model, data;
  std::vector<MatchMap> matches;  ///< best first
  bool parts_known = false;       ///< parts.json stands beside it: the matches carry samples
};

/// All that the two files tell, so that they can be written again. Of the shapes: name, coordinate system, diagonal, points (the followed
/// ones, which the file does not tell from the data's own, stand among these), and of their samples the places.
struct ReadResult {
  Params params;
  Shape model, data;
  Family family;
  std::optional<std::vector<MatchParts>> parts;     ///< none without a parts.json
  std::optional<std::vector<Symmetry>> symmetries;  ///< of a shape against itself, if its symmetry.json is there
};

/// The bytes of a file, and its name for messages.
struct NamedText {
  std::string text, file;
};

/// Reads a match.json, and parts.json in the same folder if there is one. Throws FileError for what is no such file, or when the two do not
/// belong together.
StoredFamily read_family(const std::filesystem::path& match_json);

/// The same for texts that are in memory.
StoredFamily read_family(const NamedText& match_json, const std::optional<NamedText>& parts_json);

/// The same for all that they tell. A file that lacks any of it is refused.
ReadResult read_result(const std::filesystem::path& match_json);
ReadResult read_result(const NamedText& match_json, const std::optional<NamedText>& parts_json);

}  // namespace homolog
