// SPDX-License-Identifier: MIT
#include "homolog/shape/settle_by_winding.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "homolog/base/errors.h"
#include "homolog/base/parallel.h"
#include "homolog/shape/triangle_blocks.h"
#include "homolog/shape/winding_number.h"

namespace homolog {
namespace {

constexpr double least = 0.55;  // turns; beside a sheet they come near a half, and where it is bent a little beyond
constexpr double reach = 0.9;   // voxels; the surface passes no voxel whose middle is farther from it
constexpr double sure = 0.8;    // a winding number beyond it, or below 1 - it, holds for a whole block that the surface does not come near
constexpr double most_looks = 2e9;   // at groups and triangles, 10 ns each
constexpr std::size_t one_of = 256;  // voxels tells for all
constexpr double step = 0.01;        // voxels, to the other side of the surface

bool is_inside(double turns) { return std::abs(turns) > least; }

/// Winding numbers change little where no triangle is near: one place speaks for the block unless that is in doubt.
void settle_far_block(const VoxelRange& block, const GridSurface& surface, const WindingNumber& winding,
                      const std::vector<std::uint8_t>& disputed, std::vector<float>& coverage) {
  bool known = false, is_sure = false, inside = false;
  for_each_cell(block, surface.size, [&](std::size_t i, const Vec3& middle) {
    if (!disputed[i]) return;
    if (!is_sure) {
      const double turns = winding.at(middle);
      inside = is_inside(turns);
      is_sure = !known && (std::abs(turns) > sure || std::abs(turns) < 1 - sure);
      known = true;
    }
    coverage[i] = inside ? 1 : 0;
  });
}

/// What a voxel has inside, if `nearest` is the place of the surface nearest to its middle. A sheet with the same on both sides is no
/// border.
float coverage_near(const Vec3& middle, const Vec3& nearest, const WindingNumber& winding) {
  const bool inside = is_inside(winding.at(middle));
  const Vec3 way = nearest - middle;
  const double distance = way.norm();
  if (distance >= 0.5) return inside ? 1 : 0;
  const Vec3 beyond = nearest + (distance > 0 ? step / distance : 0) * way;
  if (is_inside(winding.at(beyond)) == inside) return inside ? 1 : 0;
  return static_cast<float>(inside ? 0.5 + distance : 0.5 - distance);
}

void settle_near_block(const VoxelRange& block, const std::vector<std::uint32_t>& triangles, const GridSurface& surface,
                       const WindingNumber& winding, const std::vector<std::uint8_t>& disputed, std::vector<float>& coverage) {
  std::array<Vec3, voxels_per_block> nearest;
  std::array<double, voxels_per_block> distance;
  distance.fill(reach);
  for (const std::uint32_t t : triangles) {
    for_each_cell(voxels_near(surface, t, reach, block), surface.size, [&](std::size_t, const Vec3& middle) {
      const std::size_t slot = slot_of(middle, block);
      const Vec3 place = nearest_place(surface, t, middle);
      if ((place - middle).norm() >= distance[slot]) return;
      nearest[slot] = place;
      distance[slot] = (place - middle).norm();
    });
  }
  for_each_cell(block, surface.size, [&](std::size_t i, const Vec3& middle) {
    if (!disputed[i]) return;
    const std::size_t slot = slot_of(middle, block);
    coverage[i] = distance[slot] < reach ? coverage_near(middle, nearest[slot], winding) : is_inside(winding.at(middle)) ? 1 : 0;
  });
}

/// Of all disputed voxels in blocks that the surface comes near; of the others few are asked.
void check_work(const GridSurface& surface, const WindingNumber& winding, const TriangleBlocks& blocks,
                const std::vector<std::uint8_t>& disputed) {
  std::size_t asked = 0;
  double looks = 0;
  for (std::size_t number = 0; number < blocks.triangles.size(); ++number) {
    if (blocks.triangles[number].empty()) continue;
    for_each_cell(voxels_of(blocks, number, surface), surface.size, [&](std::size_t i, const Vec3& middle) {
      if (disputed[i] && asked++ % one_of == 0) looks += static_cast<double>(one_of * winding.looked_at(middle));
    });
  }
  if (looks > most_looks) {
    throw ShapeError("its triangles lie so loosely through each other that its inside would take minutes; repair or remesh it");
  }
}

}  // namespace

void settle_by_winding(const GridSurface& surface, const std::vector<std::uint8_t>& disputed, std::vector<float>& coverage) {
  if (std::find(disputed.begin(), disputed.end(), 1) == disputed.end()) return;
  const WindingNumber winding(surface.vertices, surface.triangles);
  const TriangleBlocks blocks = sort_into_blocks(surface, reach);
  check_work(surface, winding, blocks, disputed);
  parallel_for(blocks.triangles.size(), [&](std::size_t number) {
    const VoxelRange block = voxels_of(blocks, number, surface);
    const auto& triangles = blocks.triangles[number];
    if (triangles.empty()) {
      settle_far_block(block, surface, winding, disputed, coverage);
    } else {
      settle_near_block(block, triangles, surface, winding, disputed, coverage);
    }
    for_each_cell(block, surface.size, [&](std::size_t i, const Vec3& middle) {
      if (disputed[i]) coverage[i] = std::min(coverage[i], share_in_part(surface, middle));
    });
  });
}

}  // namespace homolog
