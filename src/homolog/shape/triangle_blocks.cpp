// SPDX-License-Identifier: MIT
#include "homolog/shape/triangle_blocks.h"

#include <algorithm>
#include <cmath>

#include "homolog/shape/nearest_surface.h"

namespace homolog {
std::size_t slot_of(const Vec3& middle, const VoxelRange& block) {
  std::size_t slot = 0;
  for (int axis = 2; axis >= 0; --axis) slot = slot * block_edge + static_cast<std::size_t>(middle[axis] - block.first[axis]);
  return slot;
}

float share_in_part(const GridSurface& surface, const Vec3& middle) {
  const Vec3 half = Vec3::Constant(0.5);
  const Vec3 sides = surface.part.max.cwiseMin(middle + half) - surface.part.min.cwiseMax(middle - half);
  return static_cast<float>(sides.cwiseMax(Vec3::Zero()).prod());
}

Vec3 nearest_place(const GridSurface& surface, std::uint32_t triangle, const Vec3& x) {
  const auto& [i, j, k] = surface.triangles[triangle];
  const Vec3 &a = surface.vertices[i], &b = surface.vertices[j], &c = surface.vertices[k];
  const Vec3 shares = nearest_on_triangle(a, b, c, x);
  return shares[0] * a + shares[1] * b + shares[2] * c;
}

VoxelRange voxels_near(const GridSurface& surface, std::uint32_t triangle, double reach, const VoxelRange& range) {
  VoxelRange near = range;
  const auto& [a, b, c] = surface.triangles[triangle];
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax({surface.vertices[a][axis], surface.vertices[b][axis], surface.vertices[c][axis]});
    const double first = range.first[axis], end = range.end[axis];
    near.first[axis] = static_cast<int>(std::clamp(std::floor(low - reach), first, end));
    near.end[axis] = static_cast<int>(std::clamp(std::ceil(high + reach), first, end));
  }
  return near;
}

TriangleBlocks sort_into_blocks(const GridSurface& surface, double reach) {
  TriangleBlocks blocks;
  for (int axis = 0; axis < 3; ++axis) blocks.size[axis] = (surface.size[axis] + block_edge - 1) / block_edge;
  blocks.triangles.resize(static_cast<std::size_t>(blocks.size[0]) * blocks.size[1] * blocks.size[2]);
  const VoxelRange all{{0, 0, 0}, surface.size};
  const double half_diagonal = std::sqrt(3) / 2 * block_edge;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    VoxelRange range = voxels_near(surface, t, reach, all);
    for (int axis = 0; axis < 3; ++axis) {
      range.first[axis] /= block_edge;
      range.end[axis] = std::min((range.end[axis] + block_edge - 1) / block_edge, blocks.size[axis]);
    }
    for_each_cell(range, blocks.size, [&](std::size_t number, const Vec3& middle) {
      const Vec3 of_block = block_edge * middle;
      if ((nearest_place(surface, t, of_block) - of_block).norm() <= reach + half_diagonal) blocks.triangles[number].push_back(t);
    });
  }
  return blocks;
}

VoxelRange voxels_of(const TriangleBlocks& blocks, std::size_t number, const GridSurface& surface) {
  const std::size_t nx = blocks.size[0], ny = blocks.size[1];
  const std::array<std::size_t, 3> block{number % nx, number / nx % ny, number / nx / ny};
  VoxelRange range;
  for (int axis = 0; axis < 3; ++axis) {
    range.first[axis] = static_cast<int>(block[axis]) * block_edge;
    range.end[axis] = std::min(range.first[axis] + block_edge, surface.size[axis]);
  }
  return range;
}

}  // namespace homolog
