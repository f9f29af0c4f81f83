// SPDX-License-Identifier: MIT
#include "homolog/shape/mesh_pieces.h"

#include <algorithm>
#include <numeric>

namespace homolog {
namespace {

/// The first vertex of a piece, its root; ways to it are made shorter as they are gone.
std::uint32_t root_of(std::uint32_t vertex, std::vector<std::uint32_t>& parent) {
  while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
  return vertex;
}

}  // namespace

Mesh kept_triangles(const Mesh& mesh, const std::vector<std::uint8_t>& kept) {
  std::vector<std::uint8_t> used(mesh.vertices.size(), 0);
  Mesh left;
  for (const auto& triangle : mesh.triangles) {
    if (!kept[triangle[0]] || !kept[triangle[1]] || !kept[triangle[2]]) continue;
    left.triangles.push_back(triangle);
    for (const std::uint32_t corner : triangle) used[corner] = 1;
  }
  std::vector<std::uint32_t> number(mesh.vertices.size(), 0);
  for (std::size_t i = 0; i < used.size(); ++i) {
    number[i] = static_cast<std::uint32_t>(left.vertices.size());
    if (used[i]) left.vertices.push_back(mesh.vertices[i]);
  }
  for (auto& triangle : left.triangles) {
    for (std::uint32_t& corner : triangle) corner = number[corner];
  }
  return left;
}

Mesh without_specks(const Mesh& mesh, std::size_t least) {
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0u);
  for (const auto& [a, b, c] : mesh.triangles) {
    for (const std::uint32_t other : {b, c}) {
      const std::uint32_t one = root_of(a, parent), two = root_of(other, parent);
      parent[std::max(one, two)] = std::min(one, two);
    }
  }
  std::vector<std::size_t> triangles(mesh.vertices.size(), 0);
  for (const auto& triangle : mesh.triangles) ++triangles[root_of(triangle[0], parent)];
  std::vector<std::uint8_t> kept(mesh.vertices.size());
  for (std::uint32_t i = 0; i < kept.size(); ++i) kept[i] = triangles[root_of(i, parent)] >= least;
  return kept_triangles(mesh, kept);
}

}  // namespace homolog
