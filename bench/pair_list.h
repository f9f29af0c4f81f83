// SPDX-License-Identifier: MIT
// The list of pairs to match: pairs.tsv of a folder in the form that bench/README.md describes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace homolog::bench {

/// One row of pairs.tsv. Models are named by their path in the folder, without ".off".
struct PairEntry {
  std::string task;  ///< whole, part, mirror or unrelated; of generated cases also scene
  std::string model, data;
  std::string truth;  ///< what the list says of the truth, in words
};

/// The task of pairs that share nothing.
inline constexpr const char* unrelated = "unrelated";

/// Reads FOLDER/pairs.tsv in its order. Throws FileError for a missing file, one that does not begin with the
/// names of its columns, or a row with too few columns.
std::vector<PairEntry> read_pairs(const std::filesystem::path& folder);

/// The set a pair belongs to: the folder of its model.
std::string set_of(const PairEntry& pair);

}  // namespace homolog::bench
