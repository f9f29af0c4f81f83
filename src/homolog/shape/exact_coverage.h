// SPDX-License-Identifier: MIT
// The exact share of every voxel that lies inside a closed surface: the volume behind each piece of a triangle within its column of
// voxels, summed by sign.
#pragma once

#include <vector>

#include "homolog/shape/ray_columns.h"

namespace homolog {

/// Per voxel, x fastest, in steps of 2^-20. For a closed surface whose winding number is 0 or 1 everywhere; empty when it is seen that it
/// is not: where shells overlap a sum of volumes is not that of the union.
std::vector<float> exact_coverage(const GridSurface& surface);

}  // namespace homolog
