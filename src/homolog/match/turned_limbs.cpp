// SPDX-License-Identifier: MIT
#include "homolog/match/turned_limbs.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "homolog/match/evidence.h"

namespace homolog {
namespace {

constexpr double most_spread = 0.13;  // extents: standard deviation of how much longer the ways from one end are
constexpr double distant = 0.1;       // of the distance between two ends counts beside the spread: the nearer of two like limbs

// How much longer the data's ways between the ends together are.
double scale_of_ways(const EndsTogether& together, const Ends& model, const Ends& data) {
  double here = 0, there = 0;
  for (std::size_t i = 0; i < together.model.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      here += way_between(model, together.model[i], together.model[j]);
      there += way_between(data, together.data[i], together.data[j]);
    }
  }
  return there / here;
}

// Standard deviation of how much longer the ways from b to the ends together are than those from a.
double spread(int a, int b, double scale, const EndsTogether& together, const Ends& model, const Ends& data) {
  const auto count = static_cast<Eigen::Index>(together.model.size());
  Eigen::ArrayXd longer(count);
  for (Eigen::Index i = 0; i < count; ++i)
    longer[i] = way_between(data, b, together.data[i]) - scale * way_between(model, a, together.model[i]);
  return std::sqrt((longer - longer.mean()).square().mean());
}

bool has(const std::vector<int>& values, int value) { return std::find(values.begin(), values.end(), value) != values.end(); }

struct Candidate {
  double cost;
  int a, b;
};

std::vector<Candidate> candidates_of(const EndsTogether& together, const Cloth& cloth, const Shape& model, const Shape& data) {
  const double extent = extent_of(cloth, model, data), scale = scale_of_ways(together, model.ends, data.ends);
  std::vector<Candidate> candidates;
  for (int a = 0; a < static_cast<int>(model.ends.nodes.size()); ++a) {
    for (int b = 0; b < static_cast<int>(data.ends.nodes.size()); ++b) {
      if (has(together.model, a) || has(together.data, b)) continue;
      const double ways = spread(a, b, scale, together, model.ends, data.ends) / extent;
      const double away = (cloth.nodes[model.ends.nodes[a]] - data.body.nodes[data.ends.nodes[b]]).norm() / extent;
      if (ways < most_spread) candidates.push_back({ways + distant * away, a, b});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) { return x.cost < y.cost; });
  return candidates;
}

}  // namespace

EndsTogether turned_ends(const EndsTogether& together, const Cloth& cloth, const Shape& model, const Shape& data) {
  EndsTogether turned;
  if (together.model.empty()) return turned;
  for (const Candidate& c : candidates_of(together, cloth, model, data)) {
    if (!has(turned.model, c.a) && !has(turned.data, c.b)) turned.model.push_back(c.a), turned.data.push_back(c.b);
  }
  return turned;
}

}  // namespace homolog
