// SPDX-License-Identifier: MIT
// The place of a surface nearest to a point, found in a tree of boxes. Ours, because CGAL's tree is GPL and Embree's is single precision.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

/// A place on a mesh.
struct SurfacePlace {
  std::uint32_t triangle = 0;       ///< its number in Mesh::triangles
  Vec3 barycentric = Vec3::Zero();  ///< shares of the three corners, 0 to 1, sum 1
  Vec3 position = Vec3::Zero();
  double distance = std::numeric_limits<double>::infinity();  ///< of the point that was asked for
};

/// Barycentric coordinates of the place of a triangle that is nearest to x; a triangle without area is its edges.
Vec3 nearest_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& x);

class NearestSurface {
 public:
  /// `normals`: one for every vertex, as vertex_normals() makes them.
  NearestSurface(Mesh mesh, std::vector<Vec3> normals);

  /// The nearest place, nearer than `reach`, whose normal (between those of its corners) is within 60 degrees of `normal`; none if there
  /// is none. Of each triangle only its nearest place is looked at. A zero `normal` agrees with every place.
  /// `likely`, a triangle, is looked at first: the answer of a neighbour spares most of the search.
  std::optional<SurfacePlace> nearest(const Vec3& x, const Vec3& normal, double reach, std::uint32_t likely = 0) const;

  const Mesh& mesh() const { return mesh_; }
  /// Between the values at the corners of a place.
  Vec3 between(const SurfacePlace& place, const std::vector<Vec3>& of_vertices) const;

 private:
  struct Node {
    Box box;
    std::uint32_t first, count;  ///< of order_, for a leaf; count 0: the children are the next node and node `first`
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t end, const std::vector<Vec3>& centres);
  void look(std::uint32_t triangle, const Vec3& x, const Vec3& normal, SurfacePlace& best) const;

  Mesh mesh_;
  std::vector<Vec3> normals_;
  std::vector<std::uint32_t> order_;  ///< triangles, leaf by leaf
  std::vector<Node> nodes_;
};

}  // namespace homolog
