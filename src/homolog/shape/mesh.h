// SPDX-License-Identifier: MIT
// A triangle mesh as read from a file, in the file's own coordinates and units.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "homolog/base/vec.h"

namespace homolog {

using Triangle = std::array<std::uint32_t, 3>;  ///< numbers of vertices, counterclockwise seen from outside

struct Mesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  bool ras = false;  ///< the file states that x runs to the right and y to the front (SPACE=RAS, as 3D Slicer writes it); else LPS is meant
};

/// Throws ShapeError if a triangle names a vertex that does not exist, or one with a coordinate that is not finite.
void check_mesh(const Mesh& mesh);

/// Turns a triangle, or all of them, over: the other side becomes the front.
inline void turn_over(Triangle& triangle) { std::swap(triangle[1], triangle[2]); }
inline void turn_over(std::vector<Triangle>& triangles) {
  for (Triangle& triangle : triangles) turn_over(triangle);
}

/// An axis-aligned box.
struct Box {
  Vec3 min = Vec3::Zero(), max = Vec3::Zero();
  double diagonal() const { return (max - min).norm(); }
};

/// The smallest box around all vertices that a triangle uses. Throws ShapeError for a mesh without triangles.
Box bounding_box(const Mesh& mesh);

/// From a place to the nearest of the box; 0 inside.
inline double square_distance(const Box& box, const Vec3& x) { return (x - x.cwiseMax(box.min).cwiseMin(box.max)).squaredNorm(); }

}  // namespace homolog
