// SPDX-License-Identifier: MIT
#include "surface_distance.h"

#include <algorithm>
#include <limits>

#include "homolog/shape/nearest_surface.h"

namespace homolog::bench {

double surface_distance(const Mesh& mesh, const Vec3& x) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const Vec3 shares = nearest_on_triangle(a, b, c, x);
    least = std::min(least, (shares[0] * a + shares[1] * b + shares[2] * c - x).norm());
  }
  return least;
}

}  // namespace homolog::bench
