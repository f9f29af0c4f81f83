// SPDX-License-Identifier: MIT
// The distance of a voxel's middle from the surface tells its coverage as if the surface were a plane there.
#include "homolog/shape/thicken.h"

#include <algorithm>
#include <array>

#include "homolog/base/parallel.h"
#include "homolog/shape/triangle_blocks.h"

namespace homolog {
namespace {

/// What is covered of a voxel, of which `inside` is in the solid, by the solid and a layer about a plane that passes the middle at a
/// distance.
float thickened(float inside, double distance, double thickness) {
  const double beyond = inside >= 0.5f ? -distance : distance;
  const double outward = 0.5 + thickness / 2 - beyond;  // up to the layer's outer side
  return static_cast<float>(std::clamp(std::min(outward, inside + thickness), static_cast<double>(inside), 1.0));
}

}  // namespace

void thicken_surface(const GridSurface& surface, double thickness, std::vector<float>& coverage) {
  const double reach = thickness / 2 + 0.5;
  const TriangleBlocks blocks = sort_into_blocks(surface, reach);
  parallel_for(blocks.triangles.size(), [&](std::size_t number) {
    if (blocks.triangles[number].empty()) return;
    const VoxelRange block = voxels_of(blocks, number, surface);
    std::array<double, voxels_per_block> nearest;
    nearest.fill(reach);
    for (const std::uint32_t t : blocks.triangles[number]) {
      for_each_cell(voxels_near(surface, t, reach, block), surface.size, [&](std::size_t, const Vec3& middle) {
        double& distance = nearest[slot_of(middle, block)];
        distance = std::min(distance, (nearest_place(surface, t, middle) - middle).norm());
      });
    }
    for_each_cell(block, surface.size, [&](std::size_t i, const Vec3& middle) {
      const double distance = nearest[slot_of(middle, block)];
      if (distance < reach) coverage[i] = std::min(thickened(coverage[i], distance, thickness), share_in_part(surface, middle));
    });
  });
}

}  // namespace homolog
