// SPDX-License-Identifier: MIT
// Sec. 6.2.2 and App. A. Sets of vertices are rows of bits; every loop over one goes upwards, so the order never depends on chance.
#include "homolog/match/cliques.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace homolog {
namespace {

using Bits = std::vector<std::uint64_t>;

template <class Visit>
void for_each_bit(const Bits& bits, const Visit& visit) {
  for (std::size_t w = 0; w < bits.size(); ++w) {
    for (std::uint64_t rest = bits[w]; rest != 0; rest &= rest - 1) visit(static_cast<int>(64 * w) + std::countr_zero(rest));
  }
}

int count_common(const Bits& bits, const std::uint64_t* row) {
  int count = 0;
  for (std::size_t w = 0; w < bits.size(); ++w) count += std::popcount(bits[w] & row[w]);
  return count;
}

int count(const Bits& bits) { return count_common(bits, bits.data()); }

Bits common(const Bits& bits, const std::uint64_t* row) {
  Bits result(bits.size());
  for (std::size_t w = 0; w < bits.size(); ++w) result[w] = bits[w] & row[w];
  return result;
}

// Bits of `bits` above `vertex`.
Bits above(Bits bits, int vertex) {
  for (int w = 0; w < vertex / 64; ++w) bits[w] = 0;
  bits[vertex / 64] &= ~((std::uint64_t{2} << (vertex % 64)) - 1);  // 2 << 63 is 0: nothing of this word remains
  return bits;
}

Bits neighbours(const Graph& graph, int vertex) { return {graph.row(vertex), graph.row(vertex) + graph.words()}; }

bool larger(const std::vector<int>& a, const std::vector<int>& b) { return a.size() > b.size(); }

class MaximalSearch {
 public:
  MaximalSearch(const Graph& graph, long budget, std::size_t most) : graph_(graph), budget_(budget), most_(most) {}

  // R: the clique so far; P: vertices that may join it; X: vertices that would, but whose cliques are known.
  void expand(Bits P, Bits X) {
    const int may_join = count(P);
    if (!spend(2L * graph_.words()) || !worthwhile(R_.size() + may_join)) return;
    if (may_join == 0) {
      if (count(X) == 0) keep();
      return;
    }
    const int u = pivot(P, X, may_join);
    if (!result_.complete) return;
    Bits branches = P;
    for (int w = 0; w < graph_.words(); ++w) branches[w] &= ~graph_.row(u)[w];
    for_each_bit(branches, [&](int v) {
      if (!result_.complete) return;
      R_.push_back(v);
      expand(common(P, graph_.row(v)), common(X, graph_.row(v)));
      R_.pop_back();
      P[v / 64] &= ~(std::uint64_t{1} << (v % 64));
      X[v / 64] |= std::uint64_t{1} << (v % 64);
    });
  }

  MaximalCliques result() {
    std::sort(result_.cliques.begin(), result_.cliques.end(),
              [](const auto& a, const auto& b) { return a.size() != b.size() ? larger(a, b) : a < b; });
    return std::move(result_);
  }

 private:
  bool spend(long work) {
    result_.work += work;
    if (result_.work > budget_) result_.complete = false;
    return result_.complete;
  }

  bool worthwhile(std::size_t size) const { return result_.cliques.size() < most_ || size > result_.cliques.back().size(); }

  void keep() {
    std::vector<int> clique = R_;
    std::sort(clique.begin(), clique.end());
    auto& kept = result_.cliques;
    if (most_ == std::numeric_limits<std::size_t>::max()) return kept.push_back(std::move(clique));
    kept.insert(std::upper_bound(kept.begin(), kept.end(), clique, larger), std::move(clique));
    if (kept.size() > most_) kept.pop_back();
  }

  // The vertex of P and X with the most neighbours in P leaves the fewest branches (Tomita).
  int pivot(const Bits& P, const Bits& X, int may_join) {
    int best = -1, best_count = -1;
    const auto consider = [&](int v) {
      if (best_count >= may_join || !spend(graph_.words())) return;
      const int joined = count_common(P, graph_.row(v));
      if (joined > best_count) best = v, best_count = joined;
    };
    for_each_bit(P, consider);
    for_each_bit(X, consider);
    return best;
  }

  const Graph& graph_;
  long budget_;
  std::size_t most_;
  std::vector<int> R_;
  MaximalCliques result_;
};

}  // namespace

Graph::Graph(int size) : size_(size), words_((size + 63) / 64), bits_(static_cast<std::size_t>(size_) * words_, 0) {}

void Graph::connect(int a, int b) {
  if (a == b || std::min(a, b) < 0 || std::max(a, b) >= size_) throw std::invalid_argument("an edge joins two different vertices");
  bits_[static_cast<std::size_t>(a) * words_ + b / 64] |= std::uint64_t{1} << (b % 64);
  bits_[static_cast<std::size_t>(b) * words_ + a / 64] |= std::uint64_t{1} << (a % 64);
}

MaximalCliques maximal_cliques(const Graph& graph, long budget, std::size_t most) {
  if (graph.size() == 0 || most == 0) return {};
  Bits all(graph.words(), 0);
  for (int v = 0; v < graph.size(); ++v) all[v / 64] |= std::uint64_t{1} << (v % 64);
  MaximalSearch search(graph, budget, most);
  search.expand(all, Bits(graph.words(), 0));
  return search.result();
}

FourCliques cliques_of_four(const Graph& graph, long budget) {
  FourCliques result;
  const auto spend = [&](long work) { return result.complete = result.complete && (budget -= work) >= 0; };
  for (int a = 0; a < graph.size() && spend(graph.words()); ++a) {
    const Bits with_a = above(neighbours(graph, a), a);
    for_each_bit(with_a, [&](int b) {
      if (!spend(graph.words())) return;
      const Bits with_ab = above(common(with_a, graph.row(b)), b);
      for_each_bit(with_ab, [&](int c) {
        if (!spend(graph.words())) return;
        for_each_bit(above(common(with_ab, graph.row(c)), c), [&](int d) {
          if (spend(1)) result.cliques.push_back({a, b, c, d});
        });
      });
    });
  }
  return result;
}

}  // namespace homolog
