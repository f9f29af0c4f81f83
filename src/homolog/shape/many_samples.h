// SPDX-License-Identifier: MIT
// sample() of volume.h at many places at once.
#pragma once

#include <vector>

#include "homolog/shape/volume.h"

namespace homolog {

/// Vectors, their coordinates side by side; behind the last, some of zeros.
struct VectorColumns {
  std::vector<double> x, y, z;

  explicit VectorColumns(const std::vector<Vec3>& vectors);
};

/// Adds the trilinear values at `middle` + `radius` * ways to `sums`, of which there are as many as in a column; all in voxels, 0 outside
/// the grid.
void add_samples(const Volume<float>& volume, const Vec3& middle, double radius, const VectorColumns& ways, float* sums);

}  // namespace homolog
