// SPDX-License-Identifier: MIT
#include "surface_ways.h"

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>

namespace homolog::bench {
namespace {

struct Flat {
  double x, y;
};

// Where c lies when its triangle is laid flat with a at the origin and b on the x axis; y >= 0.
Flat laid_flat(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 along = (b - a).normalized();
  const double x = (c - a).dot(along);
  return {x, (c - a - x * along).norm()};
}

}  // namespace

double area_of(const Mesh& mesh) {
  double twice = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    twice += (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  return twice / 2;
}

SurfaceWays::SurfaceWays(const Mesh& mesh) : mesh_(mesh), links_(mesh.vertices.size()) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> opposite;  // corners, by edge
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) opposite[std::minmax(t[k], t[(k + 1) % 3])].push_back(t[(k + 2) % 3]);
  }
  for (const auto& [edge, corners] : opposite) {
    const auto [a, b] = edge;
    link(a, b, (mesh.vertices[a] - mesh.vertices[b]).norm());
    if (corners.size() == 2) link_across(a, b, corners[0], corners[1]);
  }
}

void SurfaceWays::link(std::uint32_t a, std::uint32_t b, double length) {
  links_[a].push_back({b, length});
  links_[b].push_back({a, length});
}

void SurfaceWays::link_across(std::uint32_t a, std::uint32_t b, std::uint32_t left, std::uint32_t right) {
  const auto& at = mesh_.vertices;
  const double edge = (at[b] - at[a]).norm();
  if (edge <= 0) return;
  const Flat l = laid_flat(at[a], at[b], at[left]), r = laid_flat(at[a], at[b], at[right]);
  if (l.y + r.y <= 0) return;
  const double crossing = (l.x * r.y + r.x * l.y) / (l.y + r.y);
  if (crossing > 0 && crossing < edge) link(left, right, std::hypot(l.x - r.x, l.y + r.y));
}

std::vector<double> SurfaceWays::from(const SurfacePlace& place) const {
  std::vector<double> ways(links_.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> next;
  const auto reach = [&](std::uint32_t vertex, double way) {
    if (way >= ways[vertex]) return;
    ways[vertex] = way;
    next.emplace(way, vertex);
  };
  for (const std::uint32_t v : mesh_.triangles[place.triangle]) reach(v, (mesh_.vertices[v] - place.position).norm());
  while (!next.empty()) {
    const auto [way, vertex] = next.top();
    next.pop();
    if (way > ways[vertex]) continue;
    for (const Link& l : links_[vertex]) reach(l.vertex, way + l.length);
  }
  return ways;
}

double SurfaceWays::to(const SurfacePlace& place, const SurfacePlace& start, const std::vector<double>& ways) const {
  if (place.triangle == start.triangle) return (place.position - start.position).norm();
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t v : mesh_.triangles[place.triangle])
    least = std::min(least, ways[v] + (mesh_.vertices[v] - place.position).norm());
  return least;
}

}  // namespace homolog::bench
