// SPDX-License-Identifier: MIT
// Sec. 6.2.3, eq. 9: chamfer distance of the mapped model to the data.
// In: the model's inside, a warp, the data's inside. Out: a mean distance in data diagonals.
// Differs: a mean, not a sum, and over the part of the model near the matched points only, so that parts can be found in other shapes.
#pragma once

#include <functional>
#include <vector>

#include "homolog/base/vec.h"
#include "homolog/salient/salient_point.h"
#include "homolog/shape/inside_tree.h"
#include "homolog/shape/volume.h"

namespace homolog {

/// A place inside a solid that stands for some of its volume.
struct InteriorSample {
  Vec3 position = Vec3::Zero();
  double weight = 0;  ///< voxels
};

/// One sample for every cell of a fixed lattice, `cells` along the longest side of the grid, that holds some of the inside: at the cell's
/// fullest voxel (nearest to its middle), weighing the coverage of the whole cell. Nothing thin is lost.
std::vector<InteriorSample> sample_interior(const Interior& interior, int cells);

/// The samples within `reach` radii of one of the points.
std::vector<InteriorSample> covered_samples(const std::vector<InteriorSample>& samples, const std::vector<SalientPoint>& points,
                                            double reach);

/// DT(O') at a world point: trilinear; outside the grid, the value at the nearest place of the grid plus the way there.
double distance_at(const InsideTree& data, const Vec3& world);

/// d_c: weighted mean of DT(O') at f(x), divided by the data's diagonal. Infinite without samples.
double chamfer_distance(const std::vector<InteriorSample>& model, const std::function<Vec3(const Vec3&)>& data_from_model,
                        const InsideTree& data, double data_diagonal);

}  // namespace homolog
