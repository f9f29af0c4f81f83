// SPDX-License-Identifier: MIT
// Sec. 6.1: thin-plate splines of 3-space, f(x) = A x + t + sum_k w_k phi(|x - x_k|). Knows nothing of shapes.
// Differs: beside the paper's phi = r^3 with affine freedom, phi = r with similarity freedom only; and the paper's
// trace[W'KV] is trace[W'KW] (docs/paper_map.md).
#pragma once

#include <vector>

#include "homolog/base/vec.h"

namespace homolog {

/// phi(r) = r is the biharmonic spline of 3-space (its energy is -trace[W'KW] >= 0), r^3 the paper's.
enum class Kernel { r, r3 };

/// x -> scale * rotation * x + shift; `rotation` has determinant -1 for a mirrored one.
struct Similarity {
  double scale = 1;
  Mat3 rotation = Mat3::Identity();
  Vec3 shift = Vec3::Zero();

  Vec3 operator()(const Vec3& x) const { return scale * (rotation * x) + shift; }
};

enum class Chirality { proper, mirrored };

class ThinPlateSpline {
 public:
  /// The identity.
  ThinPlateSpline() = default;

  /// The paper's spline: sources[k] -> targets[k] exactly, phi = r^3, the affine part is free of cost. Needs n >= 4 sources that do not
  /// lie in a plane (else the energy is infinite).
  static ThinPlateSpline affine_free(const std::vector<Vec3>& sources, const std::vector<Vec3>& targets);

  /// phi = r, only a similarity of the given chirality is free of cost, so affine change is charged too. `nugget[k]` >= 0 (units of
  /// length) lets the spline miss target k, for noisy points; the fit is then an approximation. Needs n >= 2 different sources.
  static ThinPlateSpline similarity_free(const std::vector<Vec3>& sources, const std::vector<Vec3>& targets, Chirality chirality,
                                         const std::vector<double>& nugget);

  Vec3 operator()(const Vec3& x) const;

  Kernel kernel = Kernel::r;
  std::vector<Vec3> centres;                                                     ///< x_k
  std::vector<Vec3> weights;                                                     ///< w_k
  Eigen::Matrix<double, 3, 4> affine = Eigen::Matrix<double, 3, 4>::Identity();  ///< [A t]
  double energy = 0;      ///< Delta(f) >= 0: trace[W'KW] with the kernel's sign; units target^2 / source (r), target^2 / source^3 (r3)
  Similarity similarity;  ///< its free part (similarity_free only)
};

/// |x - y| or |x - y|^3.
double phi(Kernel kernel, double distance);

}  // namespace homolog
