// SPDX-License-Identifier: MIT
// The small text files in which a folder keeps its truth, one function a format (bench/README.md).
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "homolog/base/vec.h"

namespace homolog::bench {

struct IdentityGroup {
  std::vector<std::string> names;
  std::size_t vertices = 0;  ///< the first so many correspond by number
  std::size_t line = 0;      ///< of the file
};

struct Landmark {
  std::string name;
  Vec3 position;
};

/// All that a file of the folder holds, which may be nothing.
std::string content_of(const std::filesystem::path& file);

/// IDENTITY.corr.txt of a set: one group of meshes a line. Empty when there is no such file; throws FileError for a
/// malformed line.
std::vector<IdentityGroup> read_identity_groups(const std::filesystem::path& set);

/// A__B.corr.txt: vertex numbers "ia ib", from 0. Throws FileError for a malformed line, a vertex that A (of so many) or B does not have,
/// and fewer than 4 pairs.
std::vector<std::pair<int, int>> read_vertex_pairs(const std::filesystem::path& file, std::size_t a_count, std::size_t b_count);

/// X.landmarks.txt: "name x y z". Empty when there is no such file; throws FileError for a malformed line, and for
/// fewer than 4 landmarks.
std::vector<Landmark> read_landmarks(const std::filesystem::path& file);

/// For each of `landmarks`, which one it becomes when left and right are swapped: by X.symmetry.txt, else by the names'
/// _L/_R or _pos_z/_neg_z. Empty when neither tells.
std::vector<std::size_t> read_swap(const std::filesystem::path& file, const std::vector<Landmark>& landmarks);

}  // namespace homolog::bench
