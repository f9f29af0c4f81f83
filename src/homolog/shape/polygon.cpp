// SPDX-License-Identifier: MIT
#include "homolog/shape/polygon.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace homolog {
namespace {

using Corners = std::vector<std::uint32_t>;

/// Cutting ears is quadratic at best. What is left after so much work becomes a fan, which has the same winding numbers, only folds.
constexpr std::size_t most_looks_per_corner = 4096;

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

/// A polygon of which corners are cut off: which one follows and which precedes each that is left.
struct Ring {
  Corners corners;
  std::vector<std::size_t> next, before;
  std::size_t left;

  explicit Ring(Corners all) : corners(std::move(all)), next(corners.size()), before(corners.size()), left(corners.size()) {
    for (std::size_t i = 0; i < left; ++i) next[i] = (i + 1) % left, before[(i + 1) % left] = i;
  }
  void cut(std::size_t i) {
    next[before[i]] = next[i];
    before[next[i]] = before[i];
    next[i] = i;  // marks it as gone
    --left;
  }
  bool is_left(std::size_t i) const { return next[i] != i; }
};

/// Each corner that is looked at counts in `looks`.
bool is_ear(const Mesh& mesh, const Ring& ring, std::size_t i, const Vec3& normal, std::size_t& looks) {
  const auto place = [&](std::size_t k) -> const Vec3& { return mesh.vertices[ring.corners[k]]; };
  const Vec3 &a = place(ring.before[i]), &b = place(i), &c = place(ring.next[i]);
  if (turn(normal, a, b, c) <= 0) return false;
  for (std::size_t k = ring.next[ring.next[i]]; k != ring.before[i]; k = ring.next[k]) {
    ++looks;
    const Vec3& p = place(k);
    if (p == a || p == b || p == c) continue;
    if (turn(normal, a, b, p) >= 0 && turn(normal, b, c, p) >= 0 && turn(normal, c, a, p) >= 0) return false;
  }
  return true;
}

void append_fan(Mesh& mesh, const Corners& corners) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) mesh.triangles.push_back({corners[0], corners[i], corners[i + 1]});
}

/// Cuts ears off while there are any and the work is not done, and returns what is left. Cutting one changes hardly more than its two
/// neighbours, so only they are asked again, until none is left to ask.
Corners without_ears(Mesh& mesh, Corners all, const Vec3& normal) {
  Ring ring(std::move(all));
  const std::size_t most_looks = most_looks_per_corner * ring.left;
  std::size_t looks = 0;
  for (bool found = true; found && ring.left > 3 && looks < most_looks;) {
    found = false;
    std::vector<std::size_t> asked;
    for (std::size_t i = ring.corners.size(); i-- > 0;) asked.push_back(i);
    while (!asked.empty() && ring.left > 3 && looks < most_looks) {
      const std::size_t i = asked.back();
      asked.pop_back();
      if (!ring.is_left(i) || !is_ear(mesh, ring, i, normal, looks)) continue;
      const std::size_t a = ring.before[i], c = ring.next[i];
      mesh.triangles.push_back({ring.corners[a], ring.corners[i], ring.corners[c]});
      ring.cut(i);
      asked.insert(asked.end(), {c, a});
      found = true;
    }
  }
  Corners left;
  for (std::size_t i = 0; i < ring.corners.size(); ++i) {
    if (ring.is_left(i)) left.push_back(ring.corners[i]);
  }
  return left;
}

}  // namespace

void append_polygon(Mesh& mesh, std::vector<std::uint32_t> corners) {
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  if (corners.size() < 3) return;
  if (corners.size() == 3) return append_fan(mesh, corners);
  const Vec3 normal = area_vector(mesh, corners);
  if (is_convex(mesh, corners, normal)) return append_fan(mesh, corners);
  append_fan(mesh, without_ears(mesh, std::move(corners), normal));
}

}  // namespace homolog
