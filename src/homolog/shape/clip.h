// SPDX-License-Identifier: MIT
// The part of a solid that lies in a box, as far as its bounding box goes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

/// The bounding box of the solid inside `box`: of the surface clipped by it, and of the box's corners that lie inside the solid.
/// Empty (max < min) when there is nothing.
Box clipped_bounding_box(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles, const Box& box);

}  // namespace homolog
