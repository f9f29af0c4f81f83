// SPDX-License-Identifier: MIT
// Sec. 6.1: thin-plate splines of 3-space, f(x) = A x + t + sum_k w_k phi(|x - x_k|). Knows nothing of shapes.
// Differs: beside the paper's phi = r^3 with affine freedom, phi = r with similarity freedom only; and the paper's
// trace[W'KV] is trace[W'KW] (docs/paper_map.md).
#pragma once

#include <Eigen/LU>
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
  Mat4 matrix() const;  ///< of homogeneous columns
};

enum class Chirality { proper, mirrored };

/// The orthogonal matrix of the wanted determinant nearest to a covariance, and the trace of covariance times its transpose.
struct Turn {
  Mat3 rotation;
  double trace;
};
Turn nearest_turn(const Mat3& covariance, Chirality chirality);

/// The matrix [K 1; 1' 0] with K_kl = -|x_k - x_l| + nugget_k, solved once for many targets: the spline of kernel -r about the sources,
/// where `nugget[k]` >= 0 (units of length) says how far the value at source k may be missed. Needs n >= 2 different sources.
class SourceSystem {
 public:
  SourceSystem() = default;  ///< of no sources
  SourceSystem(std::vector<Vec3> sources, const std::vector<double>& nugget);

  /// Solution rows (w_1 .. w_n, t) for values given at the sources (n x 3).
  Eigen::MatrixX3d solve(const Eigen::MatrixX3d& values) const;
  /// Variance of the spline's prediction at x in units of length: about the distance to the nearest sources.
  double variance(const Vec3& x) const;
  const std::vector<Vec3>& sources() const { return sources_; }

 private:
  std::vector<Vec3> sources_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

class ThinPlateSpline {
 public:
  /// The identity.
  ThinPlateSpline() = default;

  /// The paper's spline: sources[k] -> targets[k] exactly, phi = r^3, the affine part is free of cost. Needs n >= 4 sources that do not
  /// lie in a plane (else the energy is infinite).
  static ThinPlateSpline affine_free(const std::vector<Vec3>& sources, const std::vector<Vec3>& targets);

  /// phi = r, only a similarity of the given chirality is free of cost, so affine change is charged too. With nuggets the fit is an
  /// approximation.
  static ThinPlateSpline similarity_free(const SourceSystem& system, const std::vector<Vec3>& targets, Chirality chirality);

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
