// SPDX-License-Identifier: MIT
#include "homolog/shape/polygon.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace homolog {
namespace {

using Corners = std::vector<std::uint32_t>;

/// What is left after so much work becomes a fan, which has the same winding numbers, only folds: where long ears pass many corners.
constexpr long long most_looks_per_corner = 4096;

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

/// The corners that turn right, in cells of the plane that the polygon is seen in best. Only they can lie in an ear, and as ears are cut
/// they get fewer.
class RightTurns {
 public:
  RightTurns(const Mesh& mesh, const Ring& ring, const Vec3& normal) {
    normal.cwiseAbs().maxCoeff(&across_);
    Eigen::Vector2d last = seen(mesh.vertices[ring.corners[0]]);
    first_ = last;
    for (const std::uint32_t corner : ring.corners) {
      const Eigen::Vector2d x = seen(mesh.vertices[corner]);
      first_ = first_.cwiseMin(x);
      last = last.cwiseMax(x);
    }
    along_ = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(ring.left))));
    cells_.resize(along_ * along_);
    cells_a_length_ = static_cast<double>(along_) * (last - first_).cwiseMax(1e-300).cwiseInverse();
    for (std::size_t i = 0; i < ring.corners.size(); ++i) {
      if (turn(normal, mesh.vertices[ring.corners[ring.before[i]]], mesh.vertices[ring.corners[i]],
               mesh.vertices[ring.corners[ring.next[i]]]) > 0)
        continue;
      const auto [x, y] = cell_of(seen(mesh.vertices[ring.corners[i]]));
      cells_[y * along_ + x].push_back(i);
    }
  }

  /// Whether one of them, in a cell that the triangle's box touches, is such that `is_in(corner)`. Each cell and corner is a look.
  template <class IsIn>
  bool any_near(const std::array<Vec3, 3>& triangle, long long& looks_left, const IsIn& is_in) const {
    const Eigen::Vector2d a = seen(triangle[0]), b = seen(triangle[1]), c = seen(triangle[2]);
    const auto [x0, y0] = cell_of(a.cwiseMin(b).cwiseMin(c));
    const auto [x1, y1] = cell_of(a.cwiseMax(b).cwiseMax(c));
    for (std::size_t y = y0; y <= y1; ++y) {
      for (std::size_t x = x0; x <= x1; ++x) {
        const std::vector<std::size_t>& cell = cells_[y * along_ + x];
        looks_left -= 1 + std::ssize(cell);
        if (std::any_of(cell.begin(), cell.end(), is_in)) return true;
      }
    }
    return false;
  }

 private:
  Eigen::Vector2d seen(const Vec3& x) const { return {x[(across_ + 1) % 3], x[(across_ + 2) % 3]}; }
  /// Of numbers too large to be subtracted, the first.
  std::size_t cell_along(int axis, double x) const {
    const double cell = (x - first_[axis]) * cells_a_length_[axis];
    return cell > 0 ? static_cast<std::size_t>(std::min(cell, static_cast<double>(along_ - 1))) : 0;
  }
  std::pair<std::size_t, std::size_t> cell_of(const Eigen::Vector2d& x) const { return {cell_along(0, x[0]), cell_along(1, x[1])}; }

  int across_ = 0;
  Eigen::Vector2d first_, cells_a_length_;
  std::size_t along_;
  std::vector<std::vector<std::size_t>> cells_;
};

bool is_ear(const Mesh& mesh, const Ring& ring, std::size_t i, const Vec3& normal, const RightTurns& right_turns, long long& looks_left) {
  const auto place = [&](std::size_t k) -> const Vec3& { return mesh.vertices[ring.corners[k]]; };
  const Vec3 &a = place(ring.before[i]), &b = place(i), &c = place(ring.next[i]);
  if (turn(normal, a, b, c) <= 0) return false;
  return !right_turns.any_near({a, b, c}, looks_left, [&](std::size_t k) {
    const Vec3& p = place(k);
    if (!ring.is_left(k) || p == a || p == b || p == c) return false;
    return turn(normal, a, b, p) >= 0 && turn(normal, b, c, p) >= 0 && turn(normal, c, a, p) >= 0;
  });
}

void append_fan(Mesh& mesh, const Corners& corners) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) mesh.triangles.push_back({corners[0], corners[i], corners[i + 1]});
}

/// Asks the corners in rounds, and after each round only the neighbours of those that were cut, since little changes for the others. No two
/// neighbours are cut in one round, so that ears stay short. Whether any was cut and it is worth to ask all again.
bool cut_ears(Mesh& mesh, Ring& ring, const Vec3& normal, const RightTurns& right_turns, long long& looks_left) {
  bool found = false;
  std::vector<std::size_t> asked(ring.corners.size()), next;
  std::iota(asked.begin(), asked.end(), std::size_t{0});
  std::vector<int> touched(ring.corners.size(), -1);  // in which round
  for (int round = 0; !asked.empty(); ++round, asked = std::exchange(next, {})) {
    for (const std::size_t i : asked) {
      if (ring.left <= 3 || looks_left <= 0) return false;
      if (!ring.is_left(i) || touched[i] == round || !is_ear(mesh, ring, i, normal, right_turns, looks_left)) continue;
      const std::size_t a = ring.before[i], c = ring.next[i];
      mesh.triangles.push_back({ring.corners[a], ring.corners[i], ring.corners[c]});
      ring.cut(i);
      for (const std::size_t beside : {a, c}) {
        if (std::exchange(touched[beside], round) != round) next.push_back(beside);
      }
      found = true;
    }
  }
  return found;
}

/// Cuts ears off while there are any and the work is not done, and returns what is left.
Corners without_ears(Mesh& mesh, Corners all, const Vec3& normal) {
  Ring ring(std::move(all));
  const RightTurns right_turns(mesh, ring, normal);
  long long looks_left = most_looks_per_corner * std::ssize(ring.corners);
  while (cut_ears(mesh, ring, normal, right_turns, looks_left)) {
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
