// SPDX-License-Identifier: MIT
#include "homolog/match/guided_pairs.h"

#include <algorithm>
#include <cmath>

#include "homolog/match/candidates.h"

namespace homolog {

CorrespondenceSet guided_pairs(const Cloth& cloth, const Shape& model, const Shape& data, DescriptorKind kind, const PairLimits& limits) {
  std::vector<std::pair<double, Correspondence>> options;
  for (int i = 0; i < static_cast<int>(model.points.size()); ++i) {
    const std::size_t node = model.body.point_node(i);
    for (int j = 0; j < static_cast<int>(data.points.size()); ++j) {
      const SalientPoint& target = data.points[j];
      const double farthest = std::max(limits.place, limits.least_place / target.radius);
      const double place = (cloth.nodes[node] - target.position).norm() / target.radius;
      const double radius = std::abs(std::log(target.radius / (model.points[i].radius * cloth.scales[node])));
      if (place > farthest || radius > limits.log_radius) continue;
      const double distance = descriptor_distance(model.descriptors[i], data.descriptors[j], kind);
      const double fit =
          std::pow(place / farthest, 2) + std::pow(radius / limits.log_radius, 2) + 0.5 * std::pow(distance / descriptor_spread, 2);
      options.push_back({fit, {i, j, model.points[i], target, distance, std::exp(-0.5 * fit)}});
    }
  }
  std::stable_sort(options.begin(), options.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<char> model_used(model.points.size()), data_used(data.points.size());
  CorrespondenceSet pairs;
  for (const auto& [fit, pair] : options) {
    if (model_used[pair.model] || data_used[pair.data]) continue;
    model_used[pair.model] = data_used[pair.data] = 1;
    pairs.push_back(pair);
  }
  std::sort(pairs.begin(), pairs.end(), [](const Correspondence& a, const Correspondence& b) { return a.model < b.model; });
  return pairs;
}

}  // namespace homolog
