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

/// A mesh with one vertex per position, made from triangles with corners of their own, of which it is never larger than what is kept.
class Welder {
 public:
  /// The number of the vertex at this place, a new one if there is none.
  std::uint32_t vertex_at(const Vec3& place);
  /// Left out when it has two corners in one place.
  void add_triangle(const Triangle& triangle);
  Mesh mesh;

 private:
  void enlarge();
  std::vector<std::uint32_t> table_ = {};  // numbers of vertices, at least half of it empty
};

/// The mesh with one vertex per position, in the order of first occurrence. Triangles that lose their area by it are left out.
Mesh weld(const Mesh& mesh);

}  // namespace homolog
