// SPDX-License-Identifier: MIT
#include "homolog/shape/polygon.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace homolog {
namespace {

using Corners = std::vector<std::uint32_t>;

constexpr std::size_t most_corners_for_ears = 4096;  // cutting ears is quadratic at best; a fan has the same winding numbers, only folds

Vec3 area_vector(const Mesh& mesh, const Corners& corners) {
  Vec3 sum = Vec3::Zero();
  const Vec3& apex = mesh.vertices[corners[0]];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += (mesh.vertices[corners[i]] - apex).cross(mesh.vertices[corners[i + 1]] - apex);
  }
  return sum;
}

/// Twice the area of (a, b, c) seen along `normal`, positive when it turns left.
double turn(const Vec3& normal, const Vec3& a, const Vec3& b, const Vec3& c) { return normal.dot((b - a).cross(c - a)); }

bool is_convex(const Mesh& mesh, const Corners& corners, const Vec3& normal) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 &a = mesh.vertices[corners[i]], &b = mesh.vertices[corners[(i + 1) % n]], &c = mesh.vertices[corners[(i + 2) % n]];
    if (turn(normal, a, b, c) < 0) return false;
  }
  return true;
}

bool is_ear(const Mesh& mesh, const Corners& corners, std::size_t i, const Vec3& normal) {
  const std::size_t n = corners.size(), before = (i + n - 1) % n, after = (i + 1) % n;
  const Vec3 &a = mesh.vertices[corners[before]], &b = mesh.vertices[corners[i]], &c = mesh.vertices[corners[after]];
  if (turn(normal, a, b, c) <= 0) return false;
  for (std::size_t k = 0; k < n; ++k) {
    if (k == before || k == i || k == after) continue;
    const Vec3& p = mesh.vertices[corners[k]];
    if (p == a || p == b || p == c) continue;
    if (turn(normal, a, b, p) >= 0 && turn(normal, b, c, p) >= 0 && turn(normal, c, a, p) >= 0) return false;
  }
  return true;
}

void append_fan(Mesh& mesh, const Corners& corners) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) mesh.triangles.push_back({corners[0], corners[i], corners[i + 1]});
}

}  // namespace

void append_polygon(Mesh& mesh, std::vector<std::uint32_t> corners) {
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  if (corners.size() < 3) return;
  if (corners.size() == 3 || corners.size() > most_corners_for_ears) return append_fan(mesh, corners);
  const Vec3 normal = area_vector(mesh, corners);
  if (is_convex(mesh, corners, normal)) return append_fan(mesh, corners);
  while (corners.size() > 3) {
    std::size_t ear = 0;
    while (ear < corners.size() && !is_ear(mesh, corners, ear, normal)) ++ear;
    if (ear == corners.size()) break;  // degenerate or crossing itself: the fan of the rest keeps the winding numbers
    const std::size_t n = corners.size();
    mesh.triangles.push_back({corners[(ear + n - 1) % n], corners[ear], corners[(ear + 1) % n]});
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  append_fan(mesh, corners);
}

}  // namespace homolog
