// SPDX-License-Identifier: MIT
// Sec. 3 and 4: a salient point, in the coordinates of the shape's file.
#pragma once

#include "homolog/base/vec.h"

namespace homolog {

struct SalientPoint {
  Vec3 position = Vec3::Zero();    ///< x_i
  double radius = 0;               ///< r_i, the radius of the ball that would answer at this scale
  Vec3 direction = Vec3::UnitZ();  ///< p_i, unit length; eq. 3
  double direction_length = 0;     ///< |x_i - Mean(B cap O)| / r_i: how far p_i can be trusted; 0 means no direction
  double response = 0;             ///< |L_norm| as a share of a ball's: ball 1, cylinder .79, plate .52, plane .26
};

/// y = x + r p (Sec. 6.1).
inline Vec3 tip(const SalientPoint& point) { return point.position + point.radius * point.direction; }

}  // namespace homolog
