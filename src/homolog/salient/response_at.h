// SPDX-License-Identifier: MIT
// Sec. 4.3 at one place and scale, without the scale space.
#pragma once

#include "homolog/base/parameters.h"
#include "homolog/salient/salient_point.h"
#include "homolog/shape/volume.h"

namespace homolog {

/// L_norm as a share of a ball's at `position`, read at the scale of a ball of this radius (world units): what SalientPoint::response is at
/// the minima.
double response_at(const Interior& interior, const Vec3& position, double radius, const SalientParams& params);

}  // namespace homolog
