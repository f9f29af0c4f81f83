// SPDX-License-Identifier: MIT
// What the rays of all three axes say of every voxel, side by side.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "homolog/shape/ray_columns.h"

namespace homolog {

/// A row of voxels along x.
struct RowSums {
  int y, z;
  std::array<const std::int32_t*, 3> sums;  ///< by axis: `full_coverage` for a voxel that is wholly inside
  float lost_x;                             ///< share of the voxels' rays along x that do not close
  const float *lost_y, *lost_z;             ///< the same along y and z, per voxel
  bool any_lost;
};

/// Calls visit(row) once for every row, in any order and on any thread.
void visit_axis_sums(const GridSurface& surface, const std::function<void(const RowSums&)>& visit);

}  // namespace homolog
