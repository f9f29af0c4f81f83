// SPDX-License-Identifier: MIT
#include "homolog/match/local_map.h"

#include <Eigen/Geometry>

namespace homolog {

LocalMap local_map(const ThinPlateSpline& spline, const Vec3& x) {
  LocalMap local{spline.affine.leftCols<3>() * x + spline.affine.col(3), spline.affine.leftCols<3>()};
  for (std::size_t k = 0; k < spline.centres.size(); ++k) {
    const Vec3 way = x - spline.centres[k];
    const double distance = way.norm();
    if (!(distance > 0)) continue;
    const double slope = spline.kernel == Kernel::r ? 1 / distance : 3 * distance;  // of phi, over the distance
    local.position += spline.weights[k] * phi(spline.kernel, distance);
    local.gradient += (slope * spline.weights[k]) * way.transpose();
  }
  return local;
}

Vec3 mapped_normal(const Mat3& gradient, const Vec3& normal) {
  Mat3 cofactors;  // det(J) J^-T, finite for a singular J
  for (int k = 0; k < 3; ++k) cofactors.col(k) = gradient.col((k + 1) % 3).cross(gradient.col((k + 2) % 3));
  return (gradient.determinant() < 0 ? -1 : 1) * (cofactors * normal).normalized();
}

}  // namespace homolog
