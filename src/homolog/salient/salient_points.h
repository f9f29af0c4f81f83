// SPDX-License-Identifier: MIT
// Sec. 4.2 and 4.3: salient points as minima of the scale space over space and scale, refined below the voxel and the scale step.
#pragma once

#include <vector>

#include "homolog/base/parameters.h"
#include "homolog/salient/salient_point.h"
#include "homolog/shape/volume.h"

namespace homolog {

/// All salient points with response >= params.threshold, largest radius first (ties by place). Positions and radii in world units;
/// directions are filled in by find_directions. A ball of radius r >= 2.2 sigma0 voxels is found with r within 1 %.
std::vector<SalientPoint> find_salient_points(const Interior& interior, const SalientParams& params);

}  // namespace homolog
