// SPDX-License-Identifier: MIT
#include "homolog/shape/winding_number.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "homolog/base/halve.h"

namespace homolog {
namespace {

constexpr std::uint32_t leaf_size = 4;
constexpr double far = 2.5;  // of its reaches, from where on a group is as good as its area vector

/// The solid angle that a small area far away fills, seen from the origin: it lies at `way`.
double solid_angle_of(const Vec3& area, const Vec3& way) {
  const double distance = way.norm();
  return area.dot(way) / (distance * distance * distance);
}

/// The same of a triangle; positive from behind [vanoosterom1983].
double solid_angle_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 centre = (a + b + c) / 3;
  const double reach = std::max({(a - centre).squaredNorm(), (b - centre).squaredNorm(), (c - centre).squaredNorm()});
  if (centre.squaredNorm() > far * far * reach) return solid_angle_of((b - a).cross(c - a) / 2, centre);
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

/// The triangles in such an order that nearby ones stand together, so that halves of it are groups.
void halve_all(std::vector<std::uint32_t>& order, std::size_t first, std::size_t end, const std::vector<Vec3>& centres) {
  if (end - first <= leaf_size) return;
  const std::size_t half = first + (end - first) / 2;
  const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
  halve(at(first), at(half), at(end), centres);
  halve_all(order, first, half, centres);
  halve_all(order, half, end, centres);
}

}  // namespace

WindingNumber::WindingNumber(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> order(triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<Vec3> centres;
  centres.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) centres.push_back((vertices[a] + vertices[b] + vertices[c]) / 3);
  halve_all(order, 0, order.size(), centres);
  corners_.reserve(order.size());
  for (const std::uint32_t t : order) {
    const auto& [a, b, c] = triangles[t];
    corners_.push_back({vertices[a], vertices[b], vertices[c]});
  }
  if (!order.empty()) build(0, static_cast<std::uint32_t>(order.size()));
}

std::uint32_t WindingNumber::build(std::uint32_t first, std::uint32_t end) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  Node node{Vec3::Zero(), Vec3::Zero(), 0, first, end - first};
  Vec3 weighted = Vec3::Zero(), mean = Vec3::Zero();
  double weight = 0;
  for (std::uint32_t i = first; i < end; ++i) {
    const auto& [a, b, c] = corners_[i];
    const Vec3 area = (b - a).cross(c - a) / 2;
    node.area += area;
    weight += area.norm();
    weighted += area.norm() * (a + b + c) / 3;
    mean += (a + b + c) / (3.0 * (end - first));
  }
  node.centre = weight > 0 ? weighted / weight : mean;
  for (std::uint32_t i = first; i < end; ++i) {
    for (const Vec3& corner : corners_[i]) node.reach = std::max(node.reach, (corner - node.centre).norm());
  }
  nodes_.push_back(node);
  if (end - first <= leaf_size) return number;
  const std::uint32_t half = first + (end - first) / 2;
  build(first, half);
  const std::uint32_t second = build(half, end);
  nodes_[number].first = second;
  nodes_[number].count = 0;
  return number;
}

double WindingNumber::solid_angle(std::uint32_t number, const Vec3& x) const {
  const Node& node = nodes_[number];
  const Vec3 way = node.centre - x;
  if (way.norm() > far * node.reach) return solid_angle_of(node.area, way);
  if (node.count == 0) return solid_angle(number + 1, x) + solid_angle(node.first, x);
  double sum = 0;
  for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
    sum += solid_angle_of(corners_[i][0] - x, corners_[i][1] - x, corners_[i][2] - x);
  }
  return sum;
}

std::size_t WindingNumber::looked_at(std::uint32_t number, const Vec3& x) const {
  const Node& node = nodes_[number];
  if ((node.centre - x).norm() > far * node.reach) return 1;
  return 1 + (node.count > 0 ? node.count : looked_at(number + 1, x) + looked_at(node.first, x));
}

std::size_t WindingNumber::looked_at(const Vec3& x) const { return nodes_.empty() ? 0 : looked_at(0, x); }

double WindingNumber::at(const Vec3& x) const { return nodes_.empty() ? 0 : solid_angle(0, x) / (4 * std::numbers::pi); }

}  // namespace homolog
