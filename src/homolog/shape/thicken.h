// SPDX-License-Identifier: MIT
// Gives a surface a thickness, so that sheets have an inside.
#pragma once

#include <vector>

#include "homolog/shape/ray_columns.h"

namespace homolog {

/// Adds to the coverage of the inside what lies within half the thickness, in voxels, of the surface.
void thicken_surface(const GridSurface& surface, double thickness, std::vector<float>& coverage);

}  // namespace homolog
