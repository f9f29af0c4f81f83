// SPDX-License-Identifier: MIT
#include "homolog/match/coarse_surface.h"

#include <algorithm>

#include "homolog/base/parallel.h"
#include "homolog/shape/cluster_vertices.h"
#include "homolog/shape/nearest_surface.h"
#include "homolog/shape/vertex_normals.h"

namespace homolog {
namespace {

constexpr std::size_t run = 1024;  // vertices that follow each other are mostly neighbours: the last answer is a good guess
constexpr double reach = 2;        // cells; a cluster's mean is at most the diagonal of one away from its vertices

std::vector<Vec3> cluster_normals(const ClusteredMesh& clustered, const std::vector<Vec3>& normals) {
  std::vector<Vec3> sums(clustered.mesh.vertices.size(), Vec3::Zero());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (clustered.cluster[i] != ClusteredMesh::nowhere) sums[clustered.cluster[i]] += normals[i];
  }
  for (Vec3& sum : sums) sum.normalize();
  return sums;
}

/// Where the vertices of `mesh` lie on the clustered one: at the nearest place that faces the same way, or else at their cluster.
std::vector<CoarseSurface::Place> find_places(const Mesh& mesh, const std::vector<Vec3>& normals, const std::vector<std::uint32_t>& cluster,
                                              const NearestSurface& coarse, double cell) {
  std::vector<CoarseSurface::Place> places(mesh.vertices.size());
  parallel_for((places.size() + run - 1) / run, [&](std::size_t block) {
    std::uint32_t likely = 0;
    for (std::size_t i = run * block; i < std::min(places.size(), run * (block + 1)); ++i) {
      places[i] = {{cluster[i], cluster[i], cluster[i]}, {1, 0}};
      const auto place = coarse.nearest(mesh.vertices[i], normals[i], reach * cell, likely);
      if (!place) continue;
      likely = place->triangle;
      places[i] = {coarse.mesh().triangles[likely], {static_cast<float>(place->barycentric[0]), static_cast<float>(place->barycentric[1])}};
    }
  });
  return places;
}

}  // namespace

CoarseSurface coarse_surface(const Mesh& mesh, double cell, std::size_t most) {
  std::vector<Vec3> normals = vertex_normals(mesh);
  if (mesh.vertices.size() <= most) return {mesh, std::move(normals), {}};
  const ClusteredMesh clustered = cluster_vertices(mesh, cell, normals);
  CoarseSurface surface{clustered.mesh, cluster_normals(clustered, normals), {}};
  surface.places = find_places(mesh, normals, clustered.cluster, {surface.mesh, surface.normals}, cell);
  return surface;
}

std::vector<float> values_between(const CoarseSurface& surface, std::vector<float> values) {
  if (surface.places.empty()) return values;
  std::vector<float> between;
  between.reserve(surface.places.size());
  for (const auto& [corners, shares] : surface.places) {
    const auto value = [&](int k) { return corners[k] == ClusteredMesh::nowhere ? 0.0f : values[corners[k]]; };
    const float last = value(2);  // where all are equal, so is this, to the last bit
    between.push_back(std::clamp(last + shares[0] * (value(0) - last) + shares[1] * (value(1) - last), 0.0f, 1.0f));
  }
  return between;
}

}  // namespace homolog
