// SPDX-License-Identifier: MIT
#include "homolog/match/end_pairs.h"

#include <algorithm>
#include <cmath>

#include "homolog/base/distinct.h"
#include "homolog/base/parallel.h"

namespace homolog {
namespace {

constexpr double way_spread = 0.25;         // of the logarithm of how ways between ends change
constexpr double most_cost = 2;             // of a pair: its mean squared disagreement with the others, in spreads
constexpr std::size_t most_extended = 400;  // triples

using EndPair = std::pair<int, int>;

// Logarithms of how much longer the data's way between two ends is, for all pairs of ends: ratio(a, b)(c, d) = way(b, d) / way(a, c).
class WayRatios {
 public:
  WayRatios(const Ends& model, const Ends& data) : model_(logs(model)), data_(logs(data)) {}
  double between(const EndPair& a, const EndPair& b) const { return data_(a.second, b.second) - model_(a.first, b.first); }
  int model_ends() const { return static_cast<int>(model_.rows()); }
  int data_ends() const { return static_cast<int>(data_.rows()); }

 private:
  static Eigen::MatrixXd logs(const Ends& ends) {
    const auto count = static_cast<Eigen::Index>(ends.nodes.size());
    Eigen::MatrixXd result(count, count);
    for (Eigen::Index i = 0; i < count; ++i) result.row(i) = ends.ways.row(ends.nodes[i]).array().log();
    return result;
  }
  Eigen::MatrixXd model_, data_;
};

double cost_of(const EndPair& pair, const EndPairs& set, const WayRatios& ratios) {
  double sum = 0, others = 0;
  for (const EndPair& other : set.pairs) {
    if (other == pair) continue;
    sum += std::pow((ratios.between(pair, other) - set.log_scale) / way_spread, 2);
    ++others;
  }
  return sum / others;
}

// The scale of all ways, and the score that follows; not finite where ends lie in separate pieces.
void settle(EndPairs& set, const WayRatios& ratios) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < set.pairs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) sum += ratios.between(set.pairs[i], set.pairs[j]), ++count;
  }
  set.log_scale = sum / count;
  set.score = 0;
  for (const EndPair& pair : set.pairs) set.score += 1 - 0.5 * cost_of(pair, set, ratios) / most_cost;
}

bool agrees(const EndPairs& set, const WayRatios& ratios) {
  return std::all_of(set.pairs.begin(), set.pairs.end(), [&](const EndPair& p) { return cost_of(p, set, ratios) < most_cost; });
}

// All triples of pairs that agree.
std::vector<EndPairs> triples(const WayRatios& ratios) {
  std::vector<EndPairs> all;
  std::vector<EndPair> pairs;
  for (int a = 0; a < ratios.model_ends(); ++a) {
    for (int b = 0; b < ratios.data_ends(); ++b) pairs.emplace_back(a, b);
  }
  const auto apart = [](const EndPair& p, const EndPair& q) { return p.first != q.first && p.second != q.second; };
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    for (std::size_t j = i + 1; j < pairs.size(); ++j) {
      for (std::size_t k = j + 1; apart(pairs[i], pairs[j]) && k < pairs.size(); ++k) {
        if (!apart(pairs[i], pairs[k]) || !apart(pairs[j], pairs[k])) continue;
        EndPairs set{{pairs[i], pairs[j], pairs[k]}};
        settle(set, ratios);
        if (agrees(set, ratios)) all.push_back(std::move(set));
      }
    }
  }
  return all;
}

// Adds the pair of free ends that agrees best, while one agrees.
void extend(EndPairs& set, const WayRatios& ratios) {
  const auto is_free = [&](int a, int b) {
    return std::none_of(set.pairs.begin(), set.pairs.end(), [&](const EndPair& p) { return p.first == a || p.second == b; });
  };
  for (bool grown = true; grown;) {
    grown = false;
    double best = most_cost;
    EndPair joining;
    for (int a = 0; a < ratios.model_ends(); ++a) {
      for (int b = 0; b < ratios.data_ends(); ++b) {
        const double cost = is_free(a, b) ? cost_of({a, b}, set, ratios) : most_cost;
        if (cost < best) best = cost, joining = {a, b}, grown = true;
      }
    }
    if (grown) set.pairs.push_back(joining);
    settle(set, ratios);
  }
  std::sort(set.pairs.begin(), set.pairs.end());
}

void sort_by_score(std::vector<EndPairs>& sets) {
  std::stable_sort(sets.begin(), sets.end(), [](const EndPairs& a, const EndPairs& b) { return a.score > b.score; });
}

}  // namespace

std::vector<EndPairs> pair_ends(const Ends& model, const Ends& data, std::size_t most) {
  const WayRatios ratios(model, data);
  std::vector<EndPairs> sets = triples(ratios);
  sort_by_score(sets);
  sets.resize(std::min(sets.size(), most_extended));
  parallel_for(sets.size(), [&](std::size_t i) { extend(sets[i], ratios); });
  sort_by_score(sets);
  return distinct(std::move(sets), most, [](const EndPairs& a, const EndPairs& kept) { return a.pairs == kept.pairs; });
}

}  // namespace homolog
