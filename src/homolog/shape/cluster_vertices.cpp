// SPDX-License-Identifier: MIT
#include "homolog/shape/cluster_vertices.h"

#include <algorithm>

namespace homolog {
namespace {

struct KeyedVertex {
  std::uint64_t cell;
  std::uint32_t vertex;
  auto operator<=>(const KeyedVertex&) const = default;
};

/// Which of the six ways along the axes a normal points to most.
std::uint64_t way_of(const Vec3& normal) {
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return static_cast<std::uint64_t>(2 * axis + (normal[axis] < 0));
}

/// The vertices that triangles use, sorted by the cell of a grid in which they lie and the way they face.
std::vector<KeyedVertex> sort_into_cells(const Mesh& mesh, double cell, const std::vector<Vec3>& normals) {
  std::vector<bool> used(mesh.vertices.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) used[corner] = true;
  }
  const Vec3 origin = bounding_box(mesh).min;
  std::vector<KeyedVertex> keyed;
  keyed.reserve(mesh.vertices.size());
  for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
    if (!used[i]) continue;
    const Vec3 v = (mesh.vertices[i] - origin) / cell;
    const auto part = [&](int axis) { return static_cast<std::uint64_t>(v[axis]); };
    const std::uint64_t way = normals.empty() ? 0 : way_of(normals[i]);
    keyed.push_back({way << 60 | part(2) << 40 | part(1) << 20 | part(0), i});
  }
  std::sort(keyed.begin(), keyed.end());
  return keyed;
}

}  // namespace

ClusteredMesh cluster_vertices(const Mesh& mesh, double cell, const std::vector<Vec3>& normals) {
  const std::vector<KeyedVertex> keyed = sort_into_cells(mesh, cell, normals);
  ClusteredMesh clustered{{}, std::vector<std::uint32_t>(mesh.vertices.size(), ClusteredMesh::nowhere)};
  Mesh& result = clustered.mesh;
  std::vector<std::uint32_t>& cluster_of = clustered.cluster;
  for (std::size_t begin = 0, end = 0; begin < keyed.size(); begin = end) {
    Vec3 sum = Vec3::Zero();
    for (; end < keyed.size() && keyed[end].cell == keyed[begin].cell; ++end) {
      sum += mesh.vertices[keyed[end].vertex];
      cluster_of[keyed[end].vertex] = static_cast<std::uint32_t>(result.vertices.size());
    }
    result.vertices.push_back(sum / static_cast<double>(end - begin));
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    const Triangle triangle{cluster_of[a], cluster_of[b], cluster_of[c]};
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]) result.triangles.push_back(triangle);
  }
  return clustered;
}

}  // namespace homolog
