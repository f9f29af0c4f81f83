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
};

/// What one axis says. The sums are whole numbers (exact in float), `full_coverage` for a voxel that is wholly inside.
struct AxisCoverage {
  std::vector<float> sums;         ///< per voxel, x fastest
  std::vector<std::uint8_t> open;  ///< per column of voxels: a ray of it entered and left unequally often, its coverage is a guess
};

inline constexpr int full_coverage = rays_per_voxel * rays_per_voxel << 16;

/// Adds the coverage found by rays along `axis` to the sums; inside is where the winding number is not 0. Rays that do not close are
/// guessed: by parity when they cross an even number of times, else where they are inside seen from both ends.
/// `open` of axis (0, 1, 2) is numbered (y + z ny), (x + z nx), (x + y nx).
void add_ray_coverage(const GridSurface& surface, int axis, AxisCoverage& coverage);

}  // namespace homolog
