// SPDX-License-Identifier: MIT
#include "homolog/shape/weld.h"

#include <algorithm>
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

/// Where in a table of numbers the vertex at this place stands, or may be put: the table has room.
std::uint32_t& slot_of(std::vector<std::uint32_t>& table, const std::vector<Vec3>& vertices, const Vec3& place) {
  std::size_t slot = hash_of(place) & (table.size() - 1);
  while (table[slot] != none && vertices[table[slot]] != place) slot = (slot + 1) & (table.size() - 1);
  return table[slot];
}

/// Leaders in cells twice as wide as the distance: what is near a place lies in the eight cells around the corner nearest to it.
struct LeaderTable {
  const std::vector<Vec3>& vertices;
  double distance;
  std::vector<std::uint32_t> slots;

  Vec3 cell_of(const Vec3& place) const { return (place / (2 * distance)).array().floor(); }
};

void add_leader(LeaderTable& table, std::uint32_t vertex) {
  std::size_t slot = hash_of(table.cell_of(table.vertices[vertex])) & (table.slots.size() - 1);
  while (table.slots[slot] != none) slot = (slot + 1) & (table.slots.size() - 1);
  table.slots[slot] = vertex;
}

std::uint32_t find_leader(const LeaderTable& table, const Vec3& place) {
  std::uint32_t found = none;
  double nearest = table.distance;
  const Vec3 lowest = table.cell_of(place - Vec3::Constant(table.distance));
  for (int i = 0; i < 8; ++i) {
    const Vec3 cell = lowest + Vec3(i & 1, i >> 1 & 1, i >> 2 & 1);
    std::size_t slot = hash_of(cell) & (table.slots.size() - 1);
    for (; table.slots[slot] != none; slot = (slot + 1) & (table.slots.size() - 1)) {
      const double away = (table.vertices[table.slots[slot]] - place).norm();
      if (away > nearest || (away == nearest && table.slots[slot] > found)) continue;
      found = table.slots[slot];
      nearest = away;
    }
  }
  return found;
}

}  // namespace

std::vector<std::uint32_t> nearest_leader(const std::vector<Vec3>& vertices, const std::vector<std::uint8_t>& loose, double distance) {
  const auto count = static_cast<std::size_t>(std::count(loose.begin(), loose.end(), 1));
  LeaderTable table{vertices, distance, std::vector<std::uint32_t>(std::bit_ceil(2 * count + 1), none)};
  std::vector<std::uint32_t> leader(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    leader[i] = loose[i] ? find_leader(table, vertices[i]) : i;
    if (leader[i] != none) continue;
    leader[i] = i;
    add_leader(table, i);
  }
  return leader;
}

std::vector<std::uint32_t> first_equal_vertex(const std::vector<Vec3>& vertices) {
  std::vector<std::uint32_t> table(std::bit_ceil(2 * vertices.size() + 1), none), first(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    std::uint32_t& slot = slot_of(table, vertices, vertices[i]);
    if (slot == none) slot = i;
    first[i] = slot;
  }
  return first;
}

std::uint32_t Welder::vertex_at(const Vec3& place) {
  if (table_.size() <= 2 * mesh.vertices.size()) enlarge();
  std::uint32_t& slot = slot_of(table_, mesh.vertices, place);
  if (slot == none) {
    slot = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(place);
  }
  return slot;
}

void Welder::enlarge() {
  table_.assign(std::max<std::size_t>(1024, 2 * table_.size()), none);
  for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) slot_of(table_, mesh.vertices, mesh.vertices[i]) = i;
}

void Welder::add_triangle(const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  if (a != b && b != c && c != a) mesh.triangles.push_back(triangle);
}

Mesh weld(const Mesh& mesh) {
  Welder welder;
  std::vector<std::uint32_t> number;
  number.reserve(mesh.vertices.size());
  for (const Vec3& vertex : mesh.vertices) number.push_back(welder.vertex_at(vertex));
  for (const auto& [a, b, c] : mesh.triangles) welder.add_triangle({number[a], number[b], number[c]});
  return std::move(welder.mesh);
}

}  // namespace homolog
