// SPDX-License-Identifier: MIT
#include "homolog/match/skin_routes.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <unordered_map>

#include "homolog/shape/weld.h"

namespace homolog {
namespace {

using Corners = std::array<std::uint32_t, 3>;

bool touch(const Corners& a, const Corners& b) {
  return std::any_of(a.begin(), a.end(), [&](std::uint32_t corner) { return std::find(b.begin(), b.end(), corner) != b.end(); });
}

}  // namespace

SkinRoutes::SkinRoutes(const Mesh& mesh) : mesh_(mesh), first_(first_equal_vertex(mesh.vertices)) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = first_[triangle[k]], b = first_[triangle[(k + 1) % 3]];
      edges.insert(edges.end(), {{a, b}, {b, a}});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  begin_.assign(mesh.vertices.size() + 1, 0);
  for (const auto& [a, b] : edges) ++begin_[a + 1], neighbours_.push_back(b);
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  component_.assign(mesh.vertices.size(), none);
  std::vector<std::uint32_t> open;
  for (std::uint32_t seed = 0; seed < component_.size(); ++seed) {
    if (component_[seed] != none) continue;
    component_[seed] = seed;
    for (open.assign(1, seed); !open.empty();) {
      const std::uint32_t at = open.back();
      open.pop_back();
      for (std::uint32_t i = begin_[at]; i < begin_[at + 1]; ++i) {
        if (component_[neighbours_[i]] != none) continue;
        component_[neighbours_[i]] = seed;
        open.push_back(neighbours_[i]);
      }
    }
  }
}

bool SkinRoutes::within(const SurfacePlace& from, const SurfacePlace& to, double limit) const {
  Corners start, goal;
  for (int k = 0; k < 3; ++k) {
    start[k] = first_[mesh_.triangles[from.triangle][k]];
    goal[k] = first_[mesh_.triangles[to.triangle][k]];
  }
  if (touch(start, goal)) return true;
  if ((from.position - to.position).norm() > limit) return false;
  if (component_[start[0]] != component_[goal[0]]) return true;
  const auto left = [&](std::uint32_t vertex) { return (mesh_.vertices[vertex] - to.position).norm(); };
  using Way = std::pair<double, std::uint32_t>;  // length so far and straight to the goal, vertex
  std::priority_queue<Way, std::vector<Way>, std::greater<>> open;
  std::unordered_map<std::uint32_t, double> length;
  const auto reach = [&](std::uint32_t vertex, double so_far) {
    const double least = so_far + left(vertex);
    if (!(least <= limit)) return;
    const auto [known, added] = length.try_emplace(vertex, so_far);
    if (!added && known->second <= so_far) return;
    known->second = so_far;
    open.emplace(least, vertex);
  };
  for (const std::uint32_t corner : start) reach(corner, (mesh_.vertices[corner] - from.position).norm());
  while (!open.empty()) {
    const auto [least, at] = open.top();
    open.pop();
    if (std::find(goal.begin(), goal.end(), at) != goal.end()) return true;
    const double so_far = length[at];
    if (so_far + left(at) < least) continue;  // a longer way to where a shorter one led since
    for (std::uint32_t i = begin_[at]; i < begin_[at + 1]; ++i) {
      reach(neighbours_[i], so_far + (mesh_.vertices[neighbours_[i]] - mesh_.vertices[at]).norm());
    }
  }
  return false;
}

}  // namespace homolog
