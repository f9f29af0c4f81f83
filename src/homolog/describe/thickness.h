// SPDX-License-Identifier: MIT
// Beyond the paper: how thick a solid is under its skin. Bending leaves it as it is.
#pragma once

#include <vector>

#include "homolog/describe/surface_samples.h"
#include "homolog/shape/volume.h"

namespace homolog {

/// Way from each sample straight inwards until the solid ends, in the file's units; at least a voxel and a half.
std::vector<double> thickness_at(const Interior& interior, const std::vector<SurfaceSample>& samples);

}  // namespace homolog
