// SPDX-License-Identifier: MIT
// Sec. 6.2.3. Branch and bound: the nearest eighth of a cube first, none that is farther than what has been found.
#include "homolog/shape/inside_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "homolog/base/parallel.h"

namespace homolog {
namespace {

constexpr float inside = 0.5f;
constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();

template <class Value>
bool holds(Value value) {
  if constexpr (std::is_same_v<Value, float>) return value >= inside;
  return value != 0;
}

// Cubes twice as large.
template <class Value>
Volume<std::uint8_t> coarser(const Volume<Value>& finer) {
  const auto& n = finer.frame.size;
  Volume<std::uint8_t> cubes;
  cubes.frame.size = {(n[0] + 1) / 2, (n[1] + 1) / 2, (n[2] + 1) / 2};
  cubes.values.assign(cubes.frame.voxels(), 0);
  parallel_for(cubes.frame.size[2], [&](std::size_t slice) {
    const int first = 2 * static_cast<int>(slice);
    for (int k = first; k < std::min(first + 2, n[2]); ++k) {
      for (int j = 0; j < n[1]; ++j) {
        const Value* row = &finer.at(0, j, k);
        std::uint8_t* cube_row = &cubes.at(0, j / 2, k / 2);
        for (int i = 0; i < n[0]; ++i) cube_row[i / 2] |= static_cast<std::uint8_t>(holds(row[i]));
      }
    }
  });
  return cubes;
}

// In voxels, to the nearest voxel of a cube that begins at `first` times its size.
std::int64_t square_distance(const std::array<int, 3>& first, int size, const std::array<int, 3>& voxel) {
  std::int64_t square = 0;
  for (int a = 0; a < 3; ++a) {
    const std::int64_t low = std::int64_t{first[a]} * size, way = std::max({low - voxel[a], voxel[a] - (low + size - 1), std::int64_t{0}});
    square += way * way;
  }
  return square;
}

}  // namespace

InsideTree::InsideTree(const Interior& interior) : interior_(interior) {
  levels_.push_back(coarser(interior));
  while (levels_.back().values.size() > 1) levels_.push_back(coarser(levels_.back()));
}

bool InsideTree::holds_inside(std::size_t level, const Cube& cube) const {
  const auto& [i, j, k] = cube;
  const GridFrame& frame = level == 0 ? interior_.frame : levels_[level - 1].frame;
  if (!frame.contains(i, j, k)) return false;
  return level == 0 ? holds(interior_.at(i, j, k)) : holds(levels_[level - 1].at(i, j, k));
}

void InsideTree::look(std::size_t level, const Cube& cube, const Cube& voxel, std::int64_t& least) const {
  const int size = 1 << level;
  const std::int64_t square = square_distance(cube, size, voxel);
  if (square >= least || !holds_inside(level, cube)) return;
  if (level == 0) {
    least = square;
    return;
  }
  Cube nearest;
  for (int a = 0; a < 3; ++a) nearest[a] = voxel[a] >= cube[a] * size + size / 2;
  for (int n = 0; n < 8; ++n) {  // from the child the voxel lies nearest to, which bounds the search, to the one across
    look(level - 1,
         {2 * cube[0] + (nearest[0] ^ (n & 1)), 2 * cube[1] + (nearest[1] ^ (n >> 1 & 1)), 2 * cube[2] + (nearest[2] ^ (n >> 2))}, voxel,
         least);
  }
}

float InsideTree::distance(int i, int j, int k) const {
  if (holds(interior_.at(i, j, k))) return 0;
  std::int64_t least = none;
  look(levels_.size(), {0, 0, 0}, {i, j, k}, least);
  if (least == none) return std::numeric_limits<float>::infinity();
  return static_cast<float>(interior_.frame.spacing) * std::sqrt(static_cast<float>(least));
}

}  // namespace homolog
