// SPDX-License-Identifier: MIT
// Beyond the paper: axes that turn with the shape, so that a grid along them sees the same however the shape was turned before.
#pragma once

#include "homolog/shape/mesh.h"

namespace homolog {

/// Columns, a proper rotation: the principal axes of the surface (second moments of its area), longest first. The first two point
/// to the side where the surface reaches farther (third moments). Where the moments are alike to a hundred-thousandth, as those of a cube
/// or along the sides of a square prism, the axes are as near to the mesh's own as they can be, so that rounding does not choose them. It
/// does choose the side where both reach as far; a grid in the middle of the shape does not see which. The identity for a mesh without
/// area.
Mat3 principal_axes(const Mesh& mesh);

/// The mesh with rotation * v for every vertex v.
Mesh turned(Mesh mesh, const Mat3& rotation);

}  // namespace homolog
