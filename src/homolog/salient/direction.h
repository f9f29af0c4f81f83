// SPDX-License-Identifier: MIT
// Sec. 4.3, eq. 2 and 3: the local direction p, towards "as much outside as possible".
#pragma once

#include <vector>

#include "homolog/base/parameters.h"
#include "homolog/salient/salient_point.h"
#include "homolog/shape/volume.h"

namespace homolog {

/// Fills in direction and direction_length of every point from the centre of mass of B(rho_0 r, x) cap O. A point whose offset is shorter
/// than params.direction_min keeps its place but gets direction_length 0 (the paper drops the point; that loses half of them).
void find_directions(const Interior& interior, const SalientParams& params, std::vector<SalientPoint>& points);

}  // namespace homolog
