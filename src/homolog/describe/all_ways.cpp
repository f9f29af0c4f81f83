// SPDX-License-Identifier: MIT
// Every node asks its neighbours how far they are from many sources, forwards and backwards along the body, until nothing changes: the
// sums are those of Dijkstra's ways, added up in the same order.
#include "homolog/describe/all_ways.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "homolog/base/parallel.h"
#include "homolog/base/widest_clone.h"

namespace homolog {
namespace {

constexpr std::size_t sources_a_vector = 4, vectors_a_task = 8;

/// Neighbours of node i of `order`: places in it, with their distances, from begin[i] to begin[i + 1].
struct Graph {
  std::vector<int> order;
  std::vector<std::size_t> begin, neighbour;
  std::vector<double> length;
};

/// Nodes by their ways from the first one, so that most ways run along the order.
Graph graph_of(const Body& body) {
  Graph graph;
  graph.order.resize(body.nodes.size());
  std::iota(graph.order.begin(), graph.order.end(), 0);
  const std::vector<double> from_first = shortest_ways(body, {0});
  std::stable_sort(graph.order.begin(), graph.order.end(), [&](int a, int b) { return from_first[a] < from_first[b]; });
  std::vector<std::size_t> place(body.nodes.size());
  for (std::size_t i = 0; i < graph.order.size(); ++i) place[graph.order[i]] = i;
  for (const int node : graph.order) {
    graph.begin.push_back(graph.neighbour.size());
    for (const int other : body.neighbours[node]) {
      graph.neighbour.push_back(place[other]);
      graph.length.push_back((body.nodes[other] - body.nodes[node]).norm());
    }
  }
  graph.begin.push_back(graph.neighbour.size());
  return graph;
}

/// One node's ways to the sources, `vectors_a_task` vectors of them, over its neighbours. True when one becomes shorter.
[[gnu::always_inline]] inline bool shorten(const Graph& graph, std::size_t node, FourDoubles* ways) {
  FourDoubles best[vectors_a_task];
  for (std::size_t v = 0; v < vectors_a_task; ++v) best[v] = ways[node * vectors_a_task + v];
  for (std::size_t n = graph.begin[node]; n < graph.begin[node + 1]; ++n) {
    const FourDoubles* others = ways + graph.neighbour[n] * vectors_a_task;
    for (std::size_t v = 0; v < vectors_a_task; ++v) {
      const FourDoubles longer = others[v] + graph.length[n];
      best[v] = longer < best[v] ? longer : best[v];
    }
  }
  auto shorter = best[0] < best[0];
  for (std::size_t v = 0; v < vectors_a_task; ++v) {
    FourDoubles& before = ways[node * vectors_a_task + v];
    shorter |= best[v] < before;
    before = best[v];
  }
  return (shorter[0] | shorter[1] | shorter[2] | shorter[3]) != 0;
}

HOMOLOG_WIDEST_CLONE void shorten_all(const Graph& graph, FourDoubles* ways) {
  const std::size_t count = graph.order.size();
  for (bool shorter = true; shorter;) {
    shorter = false;
    for (std::size_t i = 0; i < count; ++i) shorter |= shorten(graph, i, ways);
    for (std::size_t i = count; shorter && i-- > 0;) shorten(graph, i, ways);
  }
}

}  // namespace

Eigen::MatrixXd all_ways(const Body& body) {
  const std::size_t count = body.nodes.size(), sources = sources_a_vector * vectors_a_task;
  Eigen::MatrixXd all(count, count);
  if (count == 0) return all;
  const Graph graph = graph_of(body);
  parallel_for((count + sources - 1) / sources, [&](std::size_t task) {
    std::vector<double> ways(count * sources, std::numeric_limits<double>::infinity());
    const std::size_t first = task * sources, end = std::min(first + sources, count);
    for (std::size_t i = 0; i < count; ++i) {
      const auto node = static_cast<std::size_t>(graph.order[i]);
      if (node >= first && node < end) ways[i * sources + node - first] = 0;
    }
    shorten_all(graph, reinterpret_cast<FourDoubles*>(ways.data()));
    for (std::size_t source = first; source < end; ++source) {
      for (std::size_t i = 0; i < count; ++i) all(graph.order[i], source) = ways[i * sources + source - first];
    }
  });
  return all;
}

}  // namespace homolog
