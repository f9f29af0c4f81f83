// SPDX-License-Identifier: MIT
// Beyond the paper: a described shape in turned coordinates.
#pragma once

#include "homolog/describe/shape.h"

namespace homolog {

/// Turns whatever of the shape has a place or a direction: the grid, points, samples and body. Descriptors and lengths do not turn.
/// Shape::surface_blocks, which lie along the coordinates' axes, and what settle_body() sets are to be made anew.
void turn_shape(Shape& shape, const Mat3& rotation);

}  // namespace homolog
