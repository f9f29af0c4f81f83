// SPDX-License-Identifier: MIT
// Sec. 5.2: local spherical-harmonic descriptors of salient points.
// In: coverage voxels and salient points. Out: mu_i, from coefficients c_lm per shell in the frame of p.
// Differs: shells are read from a pyramid of averaged voxels (share, not "any point in the bin"), spaced by logarithm, and
// by default compared by the rotation-free norms |c_l| instead of |c_lm| (docs/paper_map.md).
#pragma once

#include <vector>

#include "homolog/base/parameters.h"
#include "homolog/salient/salient_point.h"
#include "homolog/shape/volume.h"

namespace homolog {

/// mu_i: shell by shell, |c_l| for l = 0..degree (free), or |c_lm| for l = 0..degree, m = 0..l with weight sqrt 2 for m > 0 (axial).
using Descriptor = std::vector<float>;
using Descriptors = std::vector<Descriptor>;

/// mu_i of every point, parallel to `points`. Beyond the grid is outside.
Descriptors compute_descriptors(const Interior& interior, const std::vector<SalientPoint>& points, const DescriptorParams& params);

/// Distance of two mu of the same kind: sum of absolute differences (free), Euclidean (axial, eq. 7).
double descriptor_distance(const Descriptor& model, const Descriptor& data, DescriptorKind kind);

}  // namespace homolog
