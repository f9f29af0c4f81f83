// SPDX-License-Identifier: MIT
#include "homolog/match/cliques.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace homolog {
namespace {

constexpr long plenty = 1L << 40;

Graph random_graph(int size, double density, unsigned seed) {
  std::mt19937 random(seed);
  Graph graph(size);
  for (int a = 0; a < size; ++a) {
    for (int b = 0; b < a; ++b) {
      if (random() < density * static_cast<double>(std::mt19937::max())) graph.connect(a, b);
    }
  }
  return graph;
}

bool complete(const Graph& graph, const std::vector<int>& vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!graph.connected(vertices[i], vertices[j])) return false;
    }
  }
  return true;
}

std::vector<std::vector<int>> maximal_by_brute_force(const Graph& graph) {
  std::vector<std::vector<int>> cliques;
  for (unsigned subset = 1; subset < 1u << graph.size(); ++subset) {
    std::vector<int> vertices;
    for (int v = 0; v < graph.size(); ++v) {
      if (subset >> v & 1) vertices.push_back(v);
    }
    if (!complete(graph, vertices)) continue;
    bool maximal = true;
    for (int v = 0; v < graph.size() && maximal; ++v) {
      const auto joined = [&](int other) { return graph.connected(v, other); };
      maximal = (subset >> v & 1) || !std::all_of(vertices.begin(), vertices.end(), joined);
    }
    if (maximal) cliques.push_back(vertices);
  }
  std::sort(cliques.begin(), cliques.end(),
            [](const auto& a, const auto& b) { return a.size() != b.size() ? a.size() > b.size() : a < b; });
  return cliques;
}

std::vector<std::array<int, 4>> fours_by_brute_force(const Graph& graph) {
  std::vector<std::array<int, 4>> cliques;
  for (int a = 0; a < graph.size(); ++a) {
    for (int b = a + 1; b < graph.size(); ++b) {
      for (int c = b + 1; c < graph.size(); ++c) {
        for (int d = c + 1; d < graph.size(); ++d) {
          if (complete(graph, {a, b, c, d})) cliques.push_back({a, b, c, d});
        }
      }
    }
  }
  return cliques;
}

TEST(Cliques, MaximalAreThoseOfBruteForce) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Graph graph = random_graph(1 + seed % 13, 0.1 + 0.2 * (seed % 5), seed);
    const MaximalCliques found = maximal_cliques(graph, plenty);
    EXPECT_TRUE(found.complete);
    EXPECT_EQ(found.cliques, maximal_by_brute_force(graph)) << "seed " << seed;
  }
}

TEST(Cliques, TheLargestFewHaveTheSizesOfBruteForce) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Graph graph = random_graph(13, 0.6, seed);
    const auto all = maximal_by_brute_force(graph);
    const auto few = maximal_cliques(graph, plenty, 3).cliques;
    ASSERT_EQ(few.size(), std::min<std::size_t>(3, all.size()));
    for (std::size_t i = 0; i < few.size(); ++i) {
      EXPECT_EQ(few[i].size(), all[i].size());
      EXPECT_THAT(all, testing::Contains(few[i]));
    }
  }
}

TEST(Cliques, FoursAreThoseOfBruteForce) {
  for (const int size : {0, 3, 4, 20, 64, 70}) {  // around the border of a word
    const Graph graph = random_graph(size, 0.5, size);
    const FourCliques found = cliques_of_four(graph, plenty);
    EXPECT_TRUE(found.complete);
    EXPECT_EQ(found.cliques, fours_by_brute_force(graph)) << "size " << size;
  }
}

TEST(Cliques, AGraphWithoutVerticesHasNone) { EXPECT_TRUE(maximal_cliques(Graph(0), plenty).cliques.empty()); }

TEST(Cliques, AVertexWithoutEdgesIsMaximal) {
  EXPECT_EQ(maximal_cliques(Graph(2), plenty).cliques, (std::vector<std::vector<int>>{{0}, {1}}));
}

TEST(Cliques, MoonMoserGraphHasThreeToTheThirdPowerCliques) {
  Graph graph(12);  // four groups of three; edges between groups only
  for (int a = 0; a < 12; ++a) {
    for (int b = 0; b < a; ++b) {
      if (a / 3 != b / 3) graph.connect(a, b);
    }
  }
  EXPECT_EQ(maximal_cliques(graph, plenty).cliques.size(), 81u);
  EXPECT_EQ(cliques_of_four(graph, plenty).cliques.size(), 81u);
}

TEST(Cliques, ASmallBudgetIsToldAndRepeats) {
  const Graph graph = random_graph(120, 0.8, 7);
  const MaximalCliques first = maximal_cliques(graph, 20000), second = maximal_cliques(graph, 20000);
  EXPECT_FALSE(first.complete);
  EXPECT_FALSE(first.cliques.empty());
  EXPECT_EQ(first.cliques, second.cliques);
  for (const auto& clique : first.cliques) EXPECT_TRUE(complete(graph, clique));
  EXPECT_FALSE(cliques_of_four(graph, 1000).complete);
  EXPECT_FALSE(cliques_of_four(graph, 1000).cliques.empty());
}

TEST(Cliques, AnEdgeNeedsTwoVertices) {
  Graph graph(3);
  EXPECT_THROW(graph.connect(1, 1), std::invalid_argument);
  EXPECT_THROW(graph.connect(0, 3), std::invalid_argument);
}

}  // namespace
}  // namespace homolog
