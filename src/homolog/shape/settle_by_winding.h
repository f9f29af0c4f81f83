// SPDX-License-Identifier: MIT
// Sec. 4.2: the inside of a surface with holes, where rays cannot tell it.
#pragma once

#include <cstdint>
#include <vector>

#include "homolog/shape/ray_columns.h"

namespace homolog {

/// Sets the coverage of the disputed voxels (not 0) by whether the surface winds clearly more than half around their middles, and of those
/// that the surface passes by its distance from there, as if it were a plane.
void settle_by_winding(const GridSurface& surface, const std::vector<std::uint8_t>& disputed, std::vector<float>& coverage);

}  // namespace homolog
