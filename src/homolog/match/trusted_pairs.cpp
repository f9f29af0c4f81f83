// SPDX-License-Identifier: MIT
#include "homolog/match/trusted_pairs.h"

#include <algorithm>
#include <cmath>

namespace homolog {
namespace {

constexpr double least_trusted = 0.75;  // before the way back
constexpr double least_confidence = 0.83;
constexpr std::size_t least_told = 7;
constexpr double same_place = 0.5;  // r of a followed point

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

void rate_pairs(CorrespondenceSet& pairs, const Cloth& cloth, double merit, double extent, const Shape& model, const Shape& data,
                DescriptorKind kind) {
  for (Correspondence& c : pairs) {
    const double miss = (cloth.nodes[model.body.point_node(c.model)] - c.data_point.position).norm() / extent;
    const double rivals = share_of_rivals(c, model, data, kind);
    c.confidence = 1 / (1 + std::exp(3.45 - 2.2 * merit + 0.4 * std::log(0.01 + miss) + 0.5 * std::log(0.02 + rivals)));
  }
}

CorrespondenceSet trusted_pairs(CorrespondenceSet rated) {
  std::erase_if(rated, [](const Correspondence& c) { return c.confidence < least_trusted; });
  return rated;
}

CorrespondenceSet told_pairs(CorrespondenceSet rated, const CorrespondenceSet& followed) {
  rated.insert(rated.end(), followed.begin(), followed.end());
  std::stable_sort(rated.begin(), rated.end(), [](const auto& a, const auto& b) { return a.confidence > b.confidence; });
  CorrespondenceSet told;
  for (const Correspondence& c : rated) {
    if (c.confidence < least_confidence && told.size() >= least_told) break;
    const bool taken = std::any_of(told.begin(), told.end(), [&](const Correspondence& other) {
      return (other.data_point.position - c.data_point.position).norm() < same_place * c.data_point.radius;
    });
    if (c.data >= 0 || !taken) told.push_back(c);
  }
  std::sort(told.begin(), told.end(), [](const auto& a, const auto& b) { return a.model < b.model; });
  return told;
}

}  // namespace homolog
