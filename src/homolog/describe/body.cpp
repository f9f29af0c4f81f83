// SPDX-License-Identifier: MIT
#include "homolog/describe/body.h"

#include <algorithm>
#include <limits>
#include <queue>

#include "homolog/base/parallel.h"
#include "homolog/describe/all_ways.h"
#include "homolog/describe/sample_blocks.h"

namespace homolog {
namespace {

constexpr int neighbour_count = 10;
constexpr int looked_at = 40;       // nearest nodes tried for them
constexpr double skin_reach = 1.7;  // spacings: so near on the skin, agreeing normals suffice

bool runs_inside(const Interior& interior, const Vec3& a, const Vec3& b) {
  const int probes = std::clamp(static_cast<int>((b - a).norm() / (2 * interior.frame.spacing)), 4, 64);
  for (int i = 1; i <= probes; ++i) {
    if (sample(interior, a + (b - a) * (i / (probes + 1.0))) < 0.3f) return false;
  }
  return true;
}

bool joined(const Interior& interior, const Body& body, int a, int b) {
  if (neighbours_on_skin(body, a, b)) return true;
  return runs_inside(interior, body.nodes[a], body.nodes[b]);
}

std::vector<int> nearest_nodes(const Body& body, int node, int count) {
  std::vector<std::pair<double, int>> order;
  for (int other = 0; other < static_cast<int>(body.nodes.size()); ++other) {
    if (other != node) order.emplace_back((body.nodes[other] - body.nodes[node]).squaredNorm(), other);
  }
  const std::size_t kept = std::min<std::size_t>(count, order.size());
  std::partial_sort(order.begin(), order.begin() + kept, order.end());
  std::vector<int> nearest;
  for (std::size_t i = 0; i < kept; ++i) nearest.push_back(order[i].second);
  return nearest;
}

void join_nodes(const Interior& interior, Body& body) {
  std::vector<std::vector<int>> outgoing(body.nodes.size());
  parallel_for(body.nodes.size(), [&](std::size_t node) {
    for (int other : nearest_nodes(body, static_cast<int>(node), looked_at)) {
      if (outgoing[node].size() == neighbour_count) break;
      // Asked in one order for both directions, so that rounding cannot make the answer one-sided.
      const int a = std::min<int>(node, other), b = std::max<int>(node, other);
      if (joined(interior, body, a, b)) outgoing[node].push_back(other);
    }
  });
  body.neighbours = outgoing;
  for (std::size_t node = 0; node < outgoing.size(); ++node) {
    for (int other : outgoing[node]) body.neighbours[other].push_back(static_cast<int>(node));
  }
  for (auto& list : body.neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
}

}  // namespace

bool neighbours_on_skin(const Body& body, int a, int b) {
  if (std::max(a, b) >= static_cast<int>(body.surface_count)) return false;
  const bool near = (body.nodes[a] - body.nodes[b]).norm() < skin_reach * body.spacing;
  return near && body.normals[a].dot(body.normals[b]) > 0.5;
}

Body build_body(const Interior& interior, const std::vector<SurfaceSample>& samples, std::size_t surface_count,
                const std::vector<SalientPoint>& points) {
  Body body;
  body.surface_count = std::min(surface_count, samples.size());
  for (std::size_t i = 0; i < body.surface_count; ++i) {
    body.nodes.push_back(samples[i].position);
    body.normals.push_back(samples[i].normal);
  }
  body.spacing = typical_spacing(body.nodes);
  for (const SalientPoint& point : points) {
    body.nodes.push_back(point.position);
    body.normals.emplace_back(Vec3::Zero());
  }
  join_nodes(interior, body);
  body.ways = all_ways(body);
  return body;
}

void settle_body(Body& body) {
  body.edges = edges_of(body.nodes, body.neighbours);
  body.skin_order = block_order({body.nodes.begin(), body.nodes.begin() + static_cast<std::ptrdiff_t>(body.surface_count)});
}

std::vector<double> shortest_ways(const Body& body, const std::vector<int>& sources) {
  std::vector<double> way(body.nodes.size(), std::numeric_limits<double>::infinity());
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> open;
  for (const int source : sources) {
    way[source] = 0;
    open.emplace(0.0, source);
  }
  while (!open.empty()) {
    const auto [length, node] = open.top();
    open.pop();
    if (length > way[node]) continue;
    for (int next : body.neighbours[node]) {
      const double longer = length + (body.nodes[next] - body.nodes[node]).norm();
      if (longer < way[next]) {
        way[next] = longer;
        open.emplace(longer, next);
      }
    }
  }
  return way;
}

Eigen::MatrixXd inner_distances(const Body& body, const Interior& interior) {
  const std::size_t count = body.nodes.size() - body.surface_count;
  Eigen::MatrixXd distances(count, count);
  parallel_for(count, [&](std::size_t i) {
    for (std::size_t j = i; j < count; ++j) {
      const std::size_t a = body.point_node(i), b = body.point_node(j);
      const bool straight = runs_inside(interior, body.nodes[a], body.nodes[b]);
      distances(i, j) = straight ? (body.nodes[a] - body.nodes[b]).norm() : body.ways(a, b);
      distances(j, i) = straight ? distances(i, j) : body.ways(b, a);
    }
  });
  return distances;
}

}  // namespace homolog
