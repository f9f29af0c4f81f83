// SPDX-License-Identifier: MIT
// The place of a surface nearest to a point, found in a tree of boxes. Ours, because CGAL's tree is GPL and Embree's is single precision.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "homolog/shape/eight_triangles.h"
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

  /// Moves its vertices elsewhere; the triangles stay.
  void move(std::vector<Vec3> vertices, std::vector<Vec3> normals);

  const Mesh& mesh() const { return mesh_; }
  /// Between the values at the corners of a place.
  Vec3 between(const SurfacePlace& place, const std::vector<Vec3>& of_vertices) const;

 private:
  /// Triangles side by side; the last one is repeated where there are fewer.
  struct Leaf {
    EightTriangles places;
    std::array<std::uint32_t, triangles_at_once> triangles;
  };
  struct Node {
    bool is_leaf;
    std::uint32_t first;  ///< its number in leaves_; or of the second child, the first being the next node
    Box box;
    Vec3 axis;          ///< of the cone of all normals within,
    double half_angle;  ///< and how wide it is: pi if they point anywhere
    double agreement;   ///< cosine between the axis and another normal below which nothing within agrees with that
  };

  std::uint32_t build(std::vector<std::uint32_t>& order, std::uint32_t first, std::uint32_t end, const std::vector<Vec3>& centres);
  void bound_leaf(Node& node);
  void bound_children(Node& node, const Node& one, const Node& other) const;
  bool agrees(const SurfacePlace& place, const Vec3& normal) const;
  void look(const Leaf& leaf, const Vec3& x, const Vec3& normal, SurfacePlace& best) const;

  Mesh mesh_;
  std::vector<Vec3> normals_;
  std::vector<Leaf> leaves_;
  std::vector<std::uint32_t> leaf_of_;  ///< of every triangle
  std::vector<Node> nodes_;
};

}  // namespace homolog
