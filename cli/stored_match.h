// SPDX-License-Identifier: MIT
// A match found before, and the two meshes that it lies between.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "console.h"
#include "homolog/outputs/read_match.h"
#include "homolog/shape/mesh.h"
#include "homolog/shape/read_limits.h"

namespace homolog::cli {

struct StoredMatchOptions {
  std::string file;        ///< match.json
  int number = 1;          ///< in the family, 1 for the best
  ReadLimits limits = {};  ///< of the meshes that are read beside it
};

/// The files of the match's folder that are read, there or not.
std::vector<std::filesystem::path> stored_files(const StoredMatchOptions& options);

/// MATCH, --match and the limits of files.
void add_stored_match_options(CLI::App& verb, StoredMatchOptions& options);

/// The family in MATCH; none, and a message that says so, when it holds no match. Throws FileError.
std::optional<StoredFamily> read_matches(const StoredMatchOptions& options);

/// The one that is asked for. Throws UsageError when there are fewer; the family holds at least one.
const MatchMap& chosen_match(const StoredFamily& family, const StoredMatchOptions& options);

/// Warns where there is no parts.json, so that no place is known to lie outside the covered part, and of a match that is hardly right.
void warn_of_doubt(const StoredFamily& family, const MatchMap& match, Console& console);

/// The mesh that was matched and that `direction` carries from: `given` if that is not empty, else the file in the folder of the match.
/// Throws FileError, also for the other shape's file, and for a mesh that has not as many vertices as the one that was matched.
Mesh stored_mesh(const StoredMatchOptions& options, const std::string& given, const StoredFamily& family, Direction direction);

/// The same, refused if it lies elsewhere (misplaced.h).
Mesh matched_mesh(const StoredMatchOptions& options, const std::string& given, const StoredFamily& family, const MatchMap& match,
                  Direction direction);

}  // namespace homolog::cli
