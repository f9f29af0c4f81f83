// SPDX-License-Identifier: MIT
// What is left of a mesh when some of it is left out.
#pragma once

#include <cstdint>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

/// The triangles all of whose vertices are kept (not 0), with the vertices that they use, in their order.
Mesh kept_triangles(const Mesh& mesh, const std::vector<std::uint8_t>& kept);

/// The mesh without the pieces of fewer than `least` triangles; triangles that share a vertex are of one piece.
Mesh without_specks(const Mesh& mesh, std::size_t least);

}  // namespace homolog
