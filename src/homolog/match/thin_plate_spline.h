// SPDX-License-Identifier: MIT
// Sec. 6.1: thin-plate splines of 3-space, f(x) = A x + t + sum_k w_k phi(|x - x_k|). Knows nothing of shapes.
// Differs: beside the paper's phi = r^3 with affine freedom, phi = -r with similarity freedom (docs/paper_map.md).
#pragma once

#include <vector>

#include "homolog/base/vec.h"

namespace homolog {

enum class Kernel { r, r3 };

class ThinPlateSpline {
 public:
  /// The identity.
  ThinPlateSpline() = default;

  /// Interpolates sources -> targets (n of each). With kernel r3 the affine part is free (the paper's system), n >= 4 not in a plane;
  /// with kernel r only the similarity is (reflections included where they fit better), n >= 1. `stiffness` >= 0, in units of
  /// the kernel, relaxes interpolation into approximation. Throws std::invalid_argument when sizes differ or are too small.
  ThinPlateSpline(std::vector<Vec3> sources, const std::vector<Vec3>& targets, Kernel kernel, double stiffness = 0);

  Vec3 operator()(const Vec3& x) const;

  Kernel kernel = Kernel::r;
  std::vector<Vec3> centres;                                       ///< x_k
  std::vector<Vec3> weights;                                       ///< w_k
  Eigen::Matrix<double, 3, 4> affine = Eigen::Matrix<double, 3, 4>::Identity();  ///< [A t]
  double energy = 0;                                               ///< trace[W' K W], units of target^2 * kernel^-1
};

}  // namespace homolog
