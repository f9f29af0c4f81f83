// SPDX-License-Identifier: MIT
#include "homolog/shape/nearest_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "homolog/base/halve.h"

namespace homolog {
namespace {

constexpr std::uint32_t leaf_size = 4;
constexpr double least_agreement = 0.5;  // cosine of 60 degrees

/// Share of b in the place of the edge ab nearest to x.
double nearest_on_edge(const Vec3& a, const Vec3& b, const Vec3& x) {
  const double square = (b - a).squaredNorm();
  return square > 0 ? std::clamp((x - a).dot(b - a) / square, 0.0, 1.0) : 0;
}

}  // namespace

Vec3 nearest_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& x) {
  const Vec3 normal = (b - a).cross(c - a);
  if (normal.squaredNorm() > 0) {
    const Vec3 shares{(c - b).cross(x - b).dot(normal), (a - c).cross(x - c).dot(normal), (b - a).cross(x - a).dot(normal)};
    if (shares.minCoeff() >= 0 && shares.sum() > 0) return shares / shares.sum();
  }
  const double ab = nearest_on_edge(a, b, x), bc = nearest_on_edge(b, c, x), ca = nearest_on_edge(c, a, x);
  Vec3 best = Vec3::UnitX();
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& shares : {Vec3(1 - ab, ab, 0), Vec3(0, 1 - bc, bc), Vec3(ca, 0, 1 - ca)}) {
    const double square = (shares[0] * a + shares[1] * b + shares[2] * c - x).squaredNorm();
    if (square < least) {
      least = square;
      best = shares;
    }
  }
  return best;
}

NearestSurface::NearestSurface(Mesh mesh, std::vector<Vec3> normals) : mesh_(std::move(mesh)), normals_(std::move(normals)) {
  const auto count = static_cast<std::uint32_t>(mesh_.triangles.size());
  order_.resize(count);
  std::iota(order_.begin(), order_.end(), 0u);
  std::vector<Vec3> centres;
  centres.reserve(count);
  for (const auto& [a, b, c] : mesh_.triangles) centres.push_back((mesh_.vertices[a] + mesh_.vertices[b] + mesh_.vertices[c]) / 3);
  if (count > 0) build(0, count, centres);
}

std::uint32_t NearestSurface::build(std::uint32_t first, std::uint32_t end, const std::vector<Vec3>& centres) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  Box box;
  box.min = Vec3::Constant(std::numeric_limits<double>::infinity());
  box.max = -box.min;
  for (std::uint32_t i = first; i < end; ++i) {
    for (const std::uint32_t corner : mesh_.triangles[order_[i]]) {
      box.min = box.min.cwiseMin(mesh_.vertices[corner]);
      box.max = box.max.cwiseMax(mesh_.vertices[corner]);
    }
  }
  nodes_.push_back({box, first, end - first});
  if (end - first <= leaf_size) return number;
  const std::uint32_t half = first + (end - first) / 2;
  halve(order_.begin() + first, order_.begin() + half, order_.begin() + end, centres);
  build(first, half, centres);
  const std::uint32_t second = build(half, end, centres);
  nodes_[number].first = second;
  nodes_[number].count = 0;
  return number;
}

void NearestSurface::look(std::uint32_t triangle, const Vec3& x, const Vec3& normal, SurfacePlace& best) const {
  const auto& [a, b, c] = mesh_.triangles[triangle];
  if (normals_[a].dot(normal) < 0 && normals_[b].dot(normal) < 0 && normals_[c].dot(normal) < 0) return;
  SurfacePlace place;
  place.triangle = triangle;
  place.barycentric = nearest_on_triangle(mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c], x);
  place.position = between(place, mesh_.vertices);
  place.distance = (place.position - x).norm();
  if (!(place.distance < best.distance)) return;
  const Vec3 own = between(place, normals_);
  if (own.dot(normal) >= least_agreement * own.norm() * normal.norm()) best = place;
}

std::optional<SurfacePlace> NearestSurface::nearest(const Vec3& x, const Vec3& normal, double reach, std::uint32_t likely) const {
  if (nodes_.empty()) return std::nullopt;
  SurfacePlace best;
  best.distance = reach;
  look(likely, x, normal, best);
  bool found = best.distance < reach;
  std::array<std::uint32_t, 64> open{};  // halving leaves at most 32 levels
  std::size_t count = 1;
  while (count > 0) {
    const std::uint32_t number = open[--count];
    const Node& node = nodes_[number];
    if (square_distance(node.box, x) >= best.distance * best.distance) continue;
    if (node.count == 0) {
      const std::uint32_t near = number + 1, far = node.first;
      const bool swapped = square_distance(nodes_[far].box, x) < square_distance(nodes_[near].box, x);
      open[count++] = swapped ? near : far;
      open[count++] = swapped ? far : near;
      continue;
    }
    const double before = best.distance;
    for (std::uint32_t i = 0; i < node.count; ++i) look(order_[node.first + i], x, normal, best);
    found = found || best.distance < before;
  }
  return found ? std::optional(best) : std::nullopt;
}

Vec3 NearestSurface::between(const SurfacePlace& place, const std::vector<Vec3>& of_vertices) const {
  const auto& [a, b, c] = mesh_.triangles[place.triangle];
  return place.barycentric[0] * of_vertices[a] + place.barycentric[1] * of_vertices[b] + place.barycentric[2] * of_vertices[c];
}

}  // namespace homolog
