// SPDX-License-Identifier: MIT
#include "homolog/describe/ends.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace homolog {
namespace {

constexpr std::size_t sources = 100;  // an even prefix of the skin stands for all of it
constexpr std::size_t most_ends = 12;
constexpr double least_prominence = 0.06;

// Mean way from the skin to each of its nodes, within its own piece of the body.
std::vector<double> mean_ways(const Body& body) {
  const std::size_t count = std::min(sources, body.surface_count);
  std::vector<double> means(body.surface_count);
  for (std::size_t node = 0; node < body.surface_count; ++node) {
    double sum = 0, reached = 0;
    for (std::size_t source = 0; source < count; ++source) {
      const double way = body.ways(node, source);
      if (std::isfinite(way)) sum += way, ++reached;
    }
    means[node] = reached > 0 ? sum / reached : 0;
  }
  return means;
}

// The hills of a height over the skin with their drops: falling water parts them, and each ends at the pass to a higher one. The
// largest drop comes first.
std::vector<std::pair<double, int>> hills(const Body& body, const std::vector<double>& height, double least_drop) {
  const int count = static_cast<int>(height.size());
  std::vector<int> order(count), root(count, -1);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return height[a] > height[b]; });
  const auto top_of = [&](int node) {
    while (root[node] != node) node = root[node] = root[root[node]];
    return node;
  };
  std::vector<std::pair<double, int>> found;
  for (const int node : order) {
    root[node] = node;
    for (const int other : body.neighbours[node]) {
      if (other >= count || root[other] < 0) continue;
      int high = top_of(node), low = top_of(other);
      if (high == low) continue;
      if (height[low] > height[high] || (height[low] == height[high] && low < high)) std::swap(high, low);
      if (height[low] - height[node] > least_drop) found.emplace_back(height[low] - height[node], low);
      root[low] = high;
    }
  }
  for (int node = 0; node < count; ++node) {
    if (root[node] == node) found.emplace_back(height[node], node);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  return found;
}

}  // namespace

Ends find_ends(const Body& body) {
  Ends ends;
  if (body.surface_count == 0) return ends;
  const std::vector<double> means = mean_ways(body);
  for (const auto& [drop, node] : hills(body, means, least_prominence * *std::max_element(means.begin(), means.end()))) {
    if (ends.nodes.size() < most_ends) ends.nodes.push_back(node);
  }
  ends.ways.resize(static_cast<Eigen::Index>(body.nodes.size()), static_cast<Eigen::Index>(ends.nodes.size()));
  for (std::size_t k = 0; k < ends.nodes.size(); ++k) ends.ways.col(k) = body.ways.col(ends.nodes[k]);
  return ends;
}

}  // namespace homolog
