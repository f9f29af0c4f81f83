// SPDX-License-Identifier: MIT
// Finds the truth of a pair among the files of a folder (bench/README.md): identity groups, corr files, landmarks with their
// symmetry, parts cut from a whole.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "homolog/shape/mesh.h"
#include "pair_list.h"
#include "truth.h"
#include "truth_files.h"

namespace homolog::bench {

/// Reads the truth of one folder; remembers the symmetries that it had to look for. Safe to call from several threads.
class TruthReader {
 public:
  explicit TruthReader(std::filesystem::path folder);

  /// The true points of a pair; none where the folder knows of no truth. Throws FileError for a malformed file.
  std::optional<TruePoints> read(const PairEntry& pair, const Mesh& model, const Mesh& data);

 private:
  const std::vector<int>& vertex_symmetry(const std::filesystem::path& set, const IdentityGroup& group);

  std::filesystem::path folder_;
  std::mutex mutex_;
  std::map<std::string, std::vector<int>> symmetries_;
};

}  // namespace homolog::bench
