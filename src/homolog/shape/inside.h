// SPDX-License-Identifier: MIT
// Sec. 4.2: what is inside a surface on a grid, closed or not.
#pragma once

#include <vector>

#include "homolog/shape/ray_columns.h"

namespace homolog {

struct Inside {
  std::vector<float> coverage;  ///< per voxel, x fastest: the share of it that is inside
  double guessed = 0;           ///< share of the inside volume on which the rays of the three axes do not agree
};

/// A closed surface: exact where its shells do not overlap (exact_coverage.h); else by rays.
Inside inside_of_closed(const GridSurface& surface);

/// The same by rays: each closes and all axes are equally right, so their mean is the coverage.
std::vector<float> coverage_by_rays(const GridSurface& surface);

/// A surface with holes: the mean of two or three axes where their rays close and they agree; elsewhere the winding number decides.
/// Nothing, when there is no voxel inside that two axes agree on: a sheet.
Inside inside_of_open(const GridSurface& surface);

}  // namespace homolog
