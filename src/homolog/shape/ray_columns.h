// SPDX-License-Identifier: MIT
// Coverage of voxels by parallel rays: exact along the ray, several rays per voxel across it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

/// Rays per voxel edge, 4 x 4 per voxel face.
inline constexpr int rays_per_voxel = 4;

/// A surface in grid coordinates: voxel i covers [i, i + 1].
struct GridSurface {
  std::array<int, 3> size;
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  Box part;  ///< only what is inside counts; within [0, size]

  std::size_t voxels() const { return static_cast<std::size_t>(size[0]) * size[1] * size[2]; }
};

/// What one axis says. The sums are whole numbers (exact in float), `full_coverage` for a voxel that is wholly inside.
struct AxisCoverage {
  std::vector<float> sums;  ///< per voxel, x fastest
  std::vector<float> lost;  ///< per column of voxels: the share of its rays that do not close (0 to 1); they add nothing to the sums
};

inline constexpr int full_coverage = rays_per_voxel * rays_per_voxel << 16;

/// Adds the coverage found by rays along `axis` to the sums; inside is where the winding number is not 0. A ray that enters and leaves
/// unequally often passes a hole and is lost. `lost` of axis (0, 1, 2) is numbered (y + z ny), (x + z nx), (x + y nx).
void add_ray_coverage(const GridSurface& surface, int axis, AxisCoverage& coverage);

}  // namespace homolog
