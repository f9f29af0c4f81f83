// SPDX-License-Identifier: MIT
#include "homolog/match/bending_invariants.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "homolog/match/contact.h"
#include "homolog/match/limbs.h"

namespace homolog {
namespace {

constexpr std::size_t posts = 50;        // an even prefix of the skin
constexpr double near = 0.08;            // extents: a post farther from the data's skin is not mapped
constexpr double long_way = 0.15;        // extents: shorter ways tell more of the nodes than of the body
constexpr double least_agreement = 0.3;  // cosine of normals
constexpr std::size_t most_ends = 8;
constexpr double end_near = 0.1, end_lost = 0.3;  // extents

// Mean distance of the values from their median, each 1 at most.
double spread(std::vector<double> values) {
  if (values.empty()) return 1;
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  const double median = values[values.size() / 2];
  const double sum = std::accumulate(values.begin(), values.end(), 0.0,
                                     [&](double total, double v) { return total + std::min(1.0, std::abs(v - median)); });
  return sum / static_cast<double>(values.size());
}

double distance_to_nearest(const Vec3& place, const std::vector<Vec3>& others) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& other : others) least = std::min(least, (other - place).squaredNorm());
  return std::sqrt(least);
}

}  // namespace

double ways_changed(const std::vector<SurfaceSample>& laid, double scale, const Shape& model, const Shape& data, double extent) {
  std::vector<std::pair<std::size_t, int>> mapped;  // model node, data node
  for (std::size_t i = 0; i < std::min(posts, laid.size()); ++i) {
    const int there = skin_node_at(data.body, laid[i], near * extent, least_agreement);
    if (there >= 0) mapped.emplace_back(i, there);
  }
  std::vector<double> factors;
  for (std::size_t a = 0; a < mapped.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const double here = scale * model.body.ways(mapped[a].first, mapped[b].first);
      const double there = std::min(data.body.ways(mapped[a].second, mapped[b].second), 10 * extent);
      if (std::isfinite(here) && std::max(here, there) > long_way * extent) factors.push_back(std::log(there / here));
    }
  }
  return spread(std::move(factors));
}

double thickness_changed(const std::vector<SurfaceSample>& laid, const std::vector<NearestSample>& nearest, const Shape& model,
                         const Shape& data, double extent) {
  std::vector<double> factors;
  for (std::size_t i = 0; i < laid.size(); ++i) {
    const NearestSample& found = nearest[i];
    if (found.sample < 0 || found.distance > skin_near * extent) continue;
    if (data.surface[found.sample].normal.dot(laid[i].normal) < least_agreement) continue;
    factors.push_back(std::log(data.thickness[found.sample] / model.thickness[i]));
  }
  return spread(std::move(factors));
}

double ends_missed(const Cloth& cloth, const Shape& model, const Shape& data, double extent) {
  const std::vector<Vec3> all_laid = places_of(model.ends, cloth.nodes);
  const std::vector<Vec3> all_there = places_of(data.ends, data.body.nodes);
  double sum = 0, count = 0;
  const auto add = [&](double distance) { sum += std::min(distance / extent, end_lost), ++count; };
  for (const Vec3& end : places_of(model.ends, cloth.nodes, most_ends)) add(distance_to_nearest(end, all_there));
  for (const Vec3& end : places_of(data.ends, data.body.nodes, most_ends)) {
    if (distance_to_nearest(end, cloth.nodes) < end_near * extent) add(distance_to_nearest(end, all_laid));
  }
  return count > 0 ? sum / count : end_lost;
}

}  // namespace homolog
