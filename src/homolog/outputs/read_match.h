// SPDX-License-Identifier: MIT
// match.json and the parts.json beside it, read again: the twin of match_json.h and parts.h. What later steps need of them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "homolog/match/transfer.h"

namespace homolog {

struct StoredShape {
  std::string file;
  bool ras = false;          ///< Mesh::ras
  std::size_t vertices = 0;  ///< of the mesh that was matched; known if the parts are
};

struct StoredFamily {
  StoredShape model, data;
  std::vector<MatchMap> matches;  ///< best first
  bool parts_known = false;       ///< parts.json stands beside it: the matches carry samples
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

}  // namespace homolog
