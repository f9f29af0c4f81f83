// SPDX-License-Identifier: MIT
#include "homolog/shape/nearest_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "homolog/base/halve.h"

namespace homolog {
namespace {

constexpr double least_agreement = 0.5;              // cosine of 60 degrees,
constexpr double most_angle = std::numbers::pi / 3;  // which is this
constexpr double wide_cone = std::numbers::pi / 2;   // a cone as wide is not convex: normals between others may leave it
constexpr double rounding = 1e-9;

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

NearestSurface::NearestSurface(Mesh mesh, std::vector<Vec3> normals) : mesh_(std::move(mesh)), leaf_of_(mesh_.triangles.size()) {
  std::vector<std::uint32_t> order(mesh_.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<Vec3> centres;
  centres.reserve(order.size());
  for (const auto& [a, b, c] : mesh_.triangles) centres.push_back((mesh_.vertices[a] + mesh_.vertices[b] + mesh_.vertices[c]) / 3);
  if (!order.empty()) build(order, 0, static_cast<std::uint32_t>(order.size()), centres);
  move(std::move(mesh_.vertices), std::move(normals));
}

std::uint32_t NearestSurface::build(std::vector<std::uint32_t>& order, std::uint32_t first, std::uint32_t end,
                                    const std::vector<Vec3>& centres) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  const bool is_leaf = end - first <= triangles_at_once;
  nodes_.push_back({is_leaf, static_cast<std::uint32_t>(leaves_.size()), {}, Vec3::Zero(), 0, 0});
  if (is_leaf) {
    Leaf& leaf = leaves_.emplace_back();
    for (std::uint32_t i = 0; i < triangles_at_once; ++i) leaf.triangles[i] = order[std::min(first + i, end - 1)];
    for (const std::uint32_t triangle : leaf.triangles) leaf_of_[triangle] = nodes_[number].first;
    return number;
  }
  const std::uint32_t half = first + ((end - first) / 2 + triangles_at_once - 1) / triangles_at_once * triangles_at_once;  // full leaves
  halve(order.begin() + first, order.begin() + half, order.begin() + end, centres);
  build(order, first, half, centres);
  const std::uint32_t second = build(order, half, end, centres);
  nodes_[number].first = second;
  return number;
}

void NearestSurface::move(std::vector<Vec3> vertices, std::vector<Vec3> normals) {
  mesh_.vertices = std::move(vertices);
  normals_ = std::move(normals);
  for (std::size_t number = nodes_.size(); number-- > 0;) {  // children before their parent
    Node& node = nodes_[number];
    if (node.is_leaf) {
      bound_leaf(node);
    } else {
      bound_children(node, nodes_[number + 1], nodes_[node.first]);
    }
    node.agreement = node.half_angle < wide_cone ? std::cos(node.half_angle + most_angle) - rounding : -2;
  }
}

void NearestSurface::bound_leaf(Node& node) {
  Leaf& leaf = leaves_[node.first];
  node.box = {Vec3::Constant(std::numeric_limits<double>::infinity()), Vec3::Constant(-std::numeric_limits<double>::infinity())};
  node.axis.setZero();
  for (std::size_t i = 0; i < triangles_at_once; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t vertex = mesh_.triangles[leaf.triangles[i]][c];
      const Vec3& place = mesh_.vertices[vertex];
      node.box.min = node.box.min.cwiseMin(place);
      node.box.max = node.box.max.cwiseMax(place);
      for (std::size_t k = 0; k < 3; ++k) leaf.places.corners[c][k][i] = place[static_cast<Eigen::Index>(k)];
      node.axis += normals_[vertex];
    }
  }
  node.axis.normalize();
  double least = 1;
  for (const std::uint32_t triangle : leaf.triangles) {
    for (const std::uint32_t vertex : mesh_.triangles[triangle]) least = std::min(least, node.axis.dot(normals_[vertex]));
  }
  node.half_angle = least > 0 ? std::acos(std::min(least, 1.0)) : std::numbers::pi;
}

void NearestSurface::bound_children(Node& node, const Node& one, const Node& other) const {
  node.box = {one.box.min.cwiseMin(other.box.min), one.box.max.cwiseMax(other.box.max)};
  node.axis = (one.axis + other.axis).normalized();
  node.half_angle = 0;
  for (const Node* child : {&one, &other}) {
    const double apart = std::acos(std::clamp(node.axis.dot(child->axis), -1.0, 1.0));
    node.half_angle = std::max(node.half_angle, std::min(apart + child->half_angle, std::numbers::pi));
  }
}

bool NearestSurface::agrees(const SurfacePlace& place, const Vec3& normal) const {
  const Vec3 own = between(place, normals_);
  return own.dot(normal) >= least_agreement * own.norm() * normal.norm();
}

void NearestSurface::look(const Leaf& leaf, const Vec3& x, const Vec3& normal, SurfacePlace& best) const {
  EightPlaces places = nearest_places(leaf.places, x);
  for (std::size_t tried = 0; tried < triangles_at_once; ++tried) {
    const auto nearest = std::min_element(places.square_distance.begin(), places.square_distance.end());
    if (!(*nearest < best.distance * best.distance)) return;
    const auto i = static_cast<std::size_t>(nearest - places.square_distance.begin());
    SurfacePlace place{leaf.triangles[i], {places.barycentric[0][i], places.barycentric[1][i], places.barycentric[2][i]}, {}, 0};
    if (agrees(place, normal)) {
      place.position = between(place, mesh_.vertices);
      place.distance = std::sqrt(*nearest);
      best = place;
      return;
    }
    *nearest = std::numeric_limits<double>::infinity();
  }
}

std::optional<SurfacePlace> NearestSurface::nearest(const Vec3& x, const Vec3& normal, double reach, std::uint32_t likely) const {
  if (nodes_.empty()) return std::nullopt;
  SurfacePlace best;
  best.distance = reach;
  look(leaves_[leaf_of_[likely]], x, normal, best);
  const double length = normal.norm();
  struct Open {
    std::uint32_t number;
    double square_distance;
  };
  std::array<Open, 64> open;  // halving leaves at most 32 levels
  open[0] = {0, square_distance(nodes_[0].box, x)};
  std::size_t count = 1;
  while (count > 0) {
    const auto [number, distance] = open[--count];
    const Node& node = nodes_[number];
    if (distance >= best.distance * best.distance || node.axis.dot(normal) < node.agreement * length) continue;
    if (node.is_leaf) {
      look(leaves_[node.first], x, normal, best);
      continue;
    }
    Open near{number + 1, square_distance(nodes_[number + 1].box, x)}, far{node.first, square_distance(nodes_[node.first].box, x)};
    if (far.square_distance < near.square_distance) std::swap(near, far);
    open[count++] = far;
    open[count++] = near;
  }
  return best.distance < reach ? std::optional(best) : std::nullopt;
}

Vec3 NearestSurface::between(const SurfacePlace& place, const std::vector<Vec3>& of_vertices) const {
  const auto& [a, b, c] = mesh_.triangles[place.triangle];
  return place.barycentric[0] * of_vertices[a] + place.barycentric[1] * of_vertices[b] + place.barycentric[2] * of_vertices[c];
}

}  // namespace homolog
