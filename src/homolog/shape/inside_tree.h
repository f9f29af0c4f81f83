// SPDX-License-Identifier: MIT
// Sec. 6.2.3: DT(O'), the exact Euclidean distance to the inside of a solid, at the voxels that are asked for.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "homolog/shape/volume.h"

namespace homolog {

/// An octree of which cubes of voxels hold some of the inside, that is a voxel with coverage >= 1/2.
class InsideTree {
 public:
  /// Refers to the interior, which must outlive it.
  explicit InsideTree(const Interior& interior);

  /// From the centre of a voxel of the grid to the nearest one inside, in world units; 0 inside, +inf where there is none.
  float distance(int i, int j, int k) const;
  const GridFrame& frame() const { return interior_.frame; }

 private:
  using Cube = std::array<int, 3>;  // its place among those of its size

  bool holds_inside(std::size_t level, const Cube& cube) const;
  void look(std::size_t level, const Cube& cube, const Cube& voxel, std::int64_t& least) const;

  const Interior& interior_;
  std::vector<Volume<std::uint8_t>> levels_;  // cubes of 2, 4, 8 ... voxels a side, up to one for all
};

}  // namespace homolog
