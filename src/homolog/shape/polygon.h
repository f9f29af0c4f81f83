// SPDX-License-Identifier: MIT
// Polygons of a file become triangles of a mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

/// Appends a polygon, given by its corners' vertex numbers, to the mesh's triangles: convex ones as a fan, others by cutting ears.
/// Fewer than three different corners (points, lines) add nothing. The corners must exist in mesh.vertices.
void append_polygon(Mesh& mesh, std::vector<std::uint32_t> corners);

}  // namespace homolog
