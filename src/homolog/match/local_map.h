// SPDX-License-Identifier: MIT
// How a thin-plate spline turns and stretches space at one place.
#pragma once

#include "homolog/match/thin_plate_spline.h"

namespace homolog {

/// A map near one place.
struct LocalMap {
  Vec3 position;  ///< f(x)
  Mat3 gradient;  ///< its derivatives
};

/// f(x) = A x + t + sum_k w_k phi(|x - x_k|) and its derivatives. At a centre, where phi = r has none, that centre's own term is left
/// out: the mean over all directions.
LocalMap local_map(const ThinPlateSpline& spline, const Vec3& x);

/// The same at many places, four at once; the same numbers to the last bit.
std::vector<LocalMap> local_maps(const ThinPlateSpline& spline, const std::vector<Vec3>& places);

/// Where an outward unit normal at x points after the map, of unit length: J^-T n, right for mirrored maps, too.
Vec3 mapped_normal(const Mat3& gradient, const Vec3& normal);

}  // namespace homolog
