// SPDX-License-Identifier: MIT
// Formats such as STL and glTF store a vertex once per face or seam; equal positions are one vertex.
#pragma once

#include <cstdint>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

/// For every vertex, the number of the first vertex with exactly the same position (0 and -0 are the same).
std::vector<std::uint32_t> first_equal_vertex(const std::vector<Vec3>& vertices);

/// For every vertex that is `loose`, the nearest of the leaders within a distance, and for the others themselves: a loose vertex is a
/// leader when none before it is so near.
std::vector<std::uint32_t> nearest_leader(const std::vector<Vec3>& vertices, const std::vector<std::uint8_t>& loose, double distance);

/// The mesh with one vertex per position, in the order of first occurrence. Triangles that lose their area by it are left out.
Mesh weld(const Mesh& mesh);

}  // namespace homolog
