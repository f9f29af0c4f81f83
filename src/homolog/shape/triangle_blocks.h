// SPDX-License-Identifier: MIT
// Which triangles come near which block of voxels, so that work near a surface need not look at all of the grid.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "homolog/shape/ray_columns.h"

namespace homolog {

/// Voxels along the edge of a block.
inline constexpr int block_edge = 4;
inline constexpr int voxels_per_block = block_edge * block_edge * block_edge;

/// Voxels [first, end) along each axis.
struct VoxelRange {
  std::array<int, 3> first, end;
};

struct TriangleBlocks {
  std::array<int, 3> size;                            ///< in blocks
  std::vector<std::vector<std::uint32_t>> triangles;  ///< per block, x fastest: numbers of those that may come within reach of it
};

/// Sorts the triangles of a surface by the blocks of its grid. `reach` in voxels.
TriangleBlocks sort_into_blocks(const GridSurface& surface, double reach);

/// The voxels of a block.
VoxelRange voxels_of(const TriangleBlocks& blocks, std::size_t number, const GridSurface& surface);

/// The voxels of a range whose middles may be within reach of a triangle.
VoxelRange voxels_near(const GridSurface& surface, std::uint32_t triangle, double reach, const VoxelRange& range);

/// Calls body(index, middle) for every cell of a range in a grid of this size, x fastest.
template <class Body>
void for_each_cell(const VoxelRange& range, const std::array<int, 3>& size, const Body& body) {
  for (int z = range.first[2]; z < range.end[2]; ++z) {
    for (int y = range.first[1]; y < range.end[1]; ++y) {
      for (int x = range.first[0]; x < range.end[0]; ++x) {
        body((static_cast<std::size_t>(z) * size[1] + y) * size[0] + x, Vec3(x + 0.5, y + 0.5, z + 0.5));
      }
    }
  }
}

/// The number within its block of the voxel with this middle, below voxels_per_block.
std::size_t slot_of(const Vec3& middle, const VoxelRange& block);

/// The share of the voxel with this middle that lies in the part.
float share_in_part(const GridSurface& surface, const Vec3& middle);

/// The place of a triangle of the surface that is nearest to x.
Vec3 nearest_place(const GridSurface& surface, std::uint32_t triangle, const Vec3& x);

}  // namespace homolog
