// SPDX-License-Identifier: MIT
#include "homolog/match/trusted_pairs.h"

#include <algorithm>
#include <cmath>

namespace homolog {
namespace {

constexpr double least_confidence = 0.75;
constexpr std::size_t least_kept = 5;

// Share of the points that are more similar to their counterpart than the pair is, mean of both directions.
double share_of_rivals(const Correspondence& pair, const Shape& model, const Shape& data, DescriptorKind kind) {
  const auto share = [&](const Descriptors& rivals, const auto& distance_of) {
    const auto nearer =
        std::count_if(rivals.begin(), rivals.end(), [&](const auto& r) { return distance_of(r) < pair.descriptor_distance; });
    return static_cast<double>(nearer) / static_cast<double>(rivals.size());
  };
  const auto &here = model.descriptors[pair.model], &there = data.descriptors[pair.data];
  return 0.5 * (share(data.descriptors, [&](const auto& r) { return descriptor_distance(here, r, kind); }) +
                share(model.descriptors, [&](const auto& r) { return descriptor_distance(r, there, kind); }));
}

}  // namespace

CorrespondenceSet trusted_pairs(CorrespondenceSet pairs, const Cloth& cloth, double merit, double extent, const Shape& model,
                                const Shape& data, DescriptorKind kind) {
  std::vector<double> confidences;
  for (Correspondence& c : pairs) {
    const double miss = (cloth.nodes[model.body.point_node(c.model)] - c.data_point.position).norm() / extent;
    const double rivals = share_of_rivals(c, model, data, kind);
    c.confidence = 1 / (1 + std::exp(3.45 - 2.2 * merit + 0.4 * std::log(0.01 + miss) + 0.5 * std::log(0.02 + rivals)));
    confidences.push_back(c.confidence);
  }
  if (pairs.size() <= least_kept) return pairs;
  std::nth_element(confidences.begin(), confidences.begin() + least_kept - 1, confidences.end(), std::greater<>());
  const double limit = std::min(least_confidence, confidences[least_kept - 1]);
  std::erase_if(pairs, [&](const Correspondence& c) { return c.confidence < limit; });
  return pairs;
}

}  // namespace homolog
