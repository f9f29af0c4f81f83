// SPDX-License-Identifier: MIT
// How much of its bounding box a surface fills: a stray triangle far away makes all the rest too small for the grid.
#pragma once

#include <string>

#include "homolog/shape/mesh.h"

namespace homolog {

/// The diagonal of the box that keeps all but the outermost half per cent of the area (a third at each corner) on each of its six
/// sides, over the diagonal of the bounding box: 0 to 1, to a thousandth. 1 where the surface has no area. Throws ShapeError for a mesh
/// without triangles.
double core_share(const Mesh& mesh);

inline constexpr double least_core_share = 0.2;  ///< below it the rest has less than 45 of 224 voxels

/// "97 % of its surface lie within 3 % of its box; ..." with what to do, if the share is below the least; else nothing.
std::string told_core(const Mesh& mesh);

}  // namespace homolog
