// SPDX-License-Identifier: MIT
#include "surface_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace homolog::bench {
namespace {

double segment_distance(const Vec3& a, const Vec3& b, const Vec3& x) {
  const double length = (b - a).squaredNorm();
  const double t = length > 0 ? std::clamp((x - a).dot(b - a) / length, 0.0, 1.0) : 0;
  return (a + t * (b - a) - x).norm();
}

double triangle_distance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& x) {
  const Vec3 normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  if (area > 0) {
    const double u = (c - b).cross(x - b).dot(normal), v = (a - c).cross(x - c).dot(normal), w = (b - a).cross(x - a).dot(normal);
    if (u >= 0 && v >= 0 && w >= 0) return std::abs((x - a).dot(normal)) / std::sqrt(area);
  }
  return std::min({segment_distance(a, b, x), segment_distance(b, c, x), segment_distance(c, a, x)});
}

}  // namespace

double surface_distance(const Mesh& mesh, const Vec3& x) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles) {
    least = std::min(least, triangle_distance(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]], x));
  }
  return least;
}

}  // namespace homolog::bench
