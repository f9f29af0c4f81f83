// SPDX-License-Identifier: MIT
// Sec. 5.2: local spherical-harmonic descriptors of salient points.
// In: coverage voxels and salient points. Out: coefficients c_lm per shell in the frame of p, and what is compared of them.
// Differs: logarithmic shells, and by default the rotation-free norms |c_l| instead of |c_lm| (docs/paper_map.md).
#pragma once

#include <complex>
#include <vector>

#include "homolog/base/parameters.h"
#include "homolog/salient/salient_point.h"
#include "homolog/shape/volume.h"

namespace homolog {

struct Descriptor {
  std::vector<std::complex<float>> coefficients;  ///< c_lm, shell by shell, l = 0..degree, m = 0..l, in the frame of p
  std::vector<float> values;                      ///< mu: what descriptor_distance compares
};
using Descriptors = std::vector<Descriptor>;

/// mu_i of every point. Points near the border see outside there.
Descriptors compute_descriptors(const Interior& interior, const std::vector<SalientPoint>& points, const DescriptorParams& params);

/// L1 distance of the two mu.
double descriptor_distance(const Descriptor& model, const Descriptor& data);

}  // namespace homolog
