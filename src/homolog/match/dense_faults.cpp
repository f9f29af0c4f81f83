// SPDX-License-Identifier: MIT
#include "homolog/match/dense_faults.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "homolog/base/parallel.h"

namespace homolog {

std::vector<std::array<std::uint32_t, 2>> edges_of(const Mesh& mesh) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangle[k], triangle[(k + 1) % 3]);
      edges.push_back({low, high});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::size_t take_torn_apart(Places& places, const Mesh& mesh, const std::vector<std::array<std::uint32_t, 2>>& edges,
                            const SkinRoutes& other, const TearLimit& limit) {
  std::vector<char> torn(edges.size(), 0);
  parallel_for(edges.size(), [&](std::size_t e) {
    const auto [a, b] = edges[e];
    if (!places[a] || !places[b]) return;
    const double length = (mesh.vertices[a] - mesh.vertices[b]).norm();
    torn[e] = !other.within(*places[a], *places[b], limit.stretch * length + limit.slack);
  });
  std::vector<int> counts(places.size(), 0);
  std::size_t all = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (torn[e]) ++all, ++counts[edges[e][0]], ++counts[edges[e][1]];
  }
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto [a, b] = edges[e];
    if (torn[e] && places[a] && places[b]) places[counts[a] > counts[b] ? a : b].reset();
  }
  return all;
}

Folds count_folds(const std::vector<Triangle>& triangles, const Places& places, const Mesh& other, const std::vector<Vec3>& normals,
                  bool mirrored) {
  Folds folds{0, 0};
  for (const auto& [a, b, c] : triangles) {
    if (!places[a] || !places[b] || !places[c]) continue;
    ++folds.triangles;
    const Vec3& corner = places[a]->position;
    const Vec3 face = (places[b]->position - corner).cross(places[c]->position - corner);
    Vec3 outward = Vec3::Zero();
    for (const std::uint32_t vertex : {a, b, c}) {
      const auto& on = other.triangles[places[vertex]->triangle];
      for (int k = 0; k < 3; ++k) outward += places[vertex]->barycentric[k] * normals[on[k]];
    }
    folds.folded += (mirrored ? -1 : 1) * face.dot(outward) < 0;
  }
  return folds;
}

}  // namespace homolog
