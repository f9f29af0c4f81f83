// SPDX-License-Identifier: MIT
#include "homolog/shape/weld.h"

#include <bit>
#include <limits>

namespace homolog {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Spreads positions over a table; 0 and -0 are the same.
std::uint64_t hash_of(const Vec3& place) {
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(place[axis] + 0.0)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
  }
  return hash;
}

}  // namespace

std::vector<std::uint32_t> first_equal_vertex(const std::vector<Vec3>& vertices) {
  std::vector<std::uint32_t> table(std::bit_ceil(2 * vertices.size() + 1), none), first(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    std::size_t slot = hash_of(vertices[i]) & (table.size() - 1);
    while (table[slot] != none && vertices[table[slot]] != vertices[i]) slot = (slot + 1) & (table.size() - 1);
    if (table[slot] == none) table[slot] = i;
    first[i] = table[slot];
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
