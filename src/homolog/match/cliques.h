// SPDX-License-Identifier: MIT
// Sec. 6.2.2 and App. A: complete subgraphs of an undirected graph: all of size four, or the maximal ones.
// In: a graph. Out: cliques, each in ascending order. Knows nothing of shapes.
// Differs: the search is budgeted, since a graph of n vertices may have 3^(n/3) maximal cliques.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace homolog {

/// Vertices 0 .. size-1; row v holds the neighbours of v as bits.
class Graph {
 public:
  explicit Graph(int size);

  /// Joins two different vertices.
  void connect(int a, int b);
  bool connected(int a, int b) const { return row(a)[b / 64] >> (b % 64) & 1; }
  int size() const { return size_; }
  int words() const { return words_; }  ///< of 64 bits a row
  const std::uint64_t* row(int vertex) const { return bits_.data() + static_cast<std::size_t>(vertex) * words_; }

 private:
  int size_, words_;
  std::vector<std::uint64_t> bits_;
};

struct MaximalCliques {
  std::vector<std::vector<int>> cliques;  ///< largest first, equal sizes in the order of their vertices
  bool complete = true;                   ///< false when the budget ended the search
  long work = 0;                          ///< words of bits touched
};

/// The `most` largest cliques that no vertex can be added to, isolated vertices included; of equal sizes those that the search meets first,
/// which favours low vertex numbers. Bron & Kerbosch 1973 with the pivot of Tomita et al. 2006, cut where no larger clique can come.
/// `budget` counts words of bits touched, so that a result cut short repeats on any machine.
MaximalCliques maximal_cliques(const Graph& graph, long budget, std::size_t most = std::numeric_limits<std::size_t>::max());

struct FourCliques {
  std::vector<std::array<int, 4>> cliques;  ///< in the order of their vertices
  bool complete = true;                     ///< false when the budget ended the search
};

/// All complete subgraphs of four vertices; `budget` counts words of bits touched and cliques found.
FourCliques cliques_of_four(const Graph& graph, long budget);

}  // namespace homolog
