// SPDX-License-Identifier: MIT
#include "homolog/shape/weld.h"

#include <algorithm>
#include <numeric>

namespace homolog {

std::vector<std::uint32_t> first_equal_vertex(const std::vector<Vec3>& vertices) {
  std::vector<std::uint32_t> order(vertices.size()), first(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    for (int axis = 0; axis < 3; ++axis) {
      if (vertices[a][axis] != vertices[b][axis]) return vertices[a][axis] < vertices[b][axis];
    }
    return a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool again = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
    first[order[i]] = again ? first[order[i - 1]] : order[i];
  }
  return first;
}

Mesh weld(const Mesh& mesh) {
  const std::vector<std::uint32_t> first = first_equal_vertex(mesh.vertices);
  std::vector<std::uint32_t> number(mesh.vertices.size());
  Mesh welded;
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    if (first[i] == i) {
      number[i] = static_cast<std::uint32_t>(welded.vertices.size());
      welded.vertices.push_back(mesh.vertices[i]);
    } else {
      number[i] = number[first[i]];
    }
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    if (number[a] != number[b] && number[b] != number[c] && number[c] != number[a]) {
      welded.triangles.push_back({number[a], number[b], number[c]});
    }
  }
  return welded;
}

}  // namespace homolog
