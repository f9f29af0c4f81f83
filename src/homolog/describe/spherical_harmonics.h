// SPDX-License-Identifier: MIT
// Sec. 5.1: orthonormal spherical harmonics Y_lm (eq. 4) and the projection of functions sampled on a sphere.
// In: values on a product grid of directions. Out: c_lm for m >= 0 (a real function's c_l,-m is (-1)^m conj c_lm).
#pragma once

#include <complex>
#include <vector>

#include "homolog/base/vec.h"

namespace homolog {

/// Number of coefficients (l, m) with 0 <= m <= l <= degree.
int harmonics_count(int degree);
/// Place of (l, m) among them.
int harmonics_index(int l, int m);

/// Gauss-Legendre colatitudes times equal longitudes: projects functions of degree <= `degree` exactly.
class SphereGrid {
 public:
  explicit SphereGrid(int degree);

  /// Unit directions, longitude running fastest.
  const std::vector<Vec3>& directions() const { return directions_; }

  /// c_lm = integral of f conj(Y_lm) over the sphere, for values of f at directions().
  std::vector<std::complex<double>> project(const std::vector<double>& values) const;

 private:
  int degree_, latitudes_, longitudes_;
  std::vector<Vec3> directions_;
  std::vector<double> legendre_;                 ///< weight * normalised P_lm, latitude by latitude
  std::vector<std::complex<double>> longitude_;  ///< exp(-i m phi), longitude by longitude
};

}  // namespace homolog
