// SPDX-License-Identifier: MIT
#include "homolog/match/seeds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "homolog/base/parallel.h"
#include "homolog/match/candidates.h"

namespace homolog {
namespace {

constexpr double ratio_limit = 0.45;  // largest disagreement of log ratios
constexpr double ratio_spread = 0.2;  // their typical disagreement when right
constexpr double radius_spread = 0.3;
constexpr double angle_spread = 0.6;  // radians
constexpr std::size_t seed_count = 300;
constexpr int uses_of_a_candidate = 6;
constexpr double infinite = std::numeric_limits<double>::infinity();

// Squared disagreement of the distance ratio with the two radius ratios, infinite beyond the limit.
double ratio_cost(double model_distance, double data_distance, double log_a, double log_b) {
  if (!std::isfinite(model_distance) || !std::isfinite(data_distance) || model_distance <= 0 || data_distance <= 0) return infinite;
  const double ratio = std::log(data_distance / model_distance);
  const double worst = std::max(std::abs(ratio - log_a), std::abs(ratio - log_b));
  const double mean = ratio - 0.5 * (log_a + log_b);
  return worst > ratio_limit ? infinite : mean * mean / (ratio_spread * ratio_spread);
}

double angle(const Vec3& a, const Vec3& b) { return std::acos(std::clamp(a.dot(b), -1.0, 1.0)); }

// Disagreement of the directions p with the baseline and with each other.
double direction_cost(const Correspondence& a, const Correspondence& b) {
  const Vec3 u = (b.model_point.position - a.model_point.position).normalized();
  const Vec3 v = (b.data_point.position - a.data_point.position).normalized();
  const bool has_a = a.model_point.direction_length > 0 && a.data_point.direction_length > 0;
  const bool has_b = b.model_point.direction_length > 0 && b.data_point.direction_length > 0;
  double sum = 0;
  const auto add = [&](double difference) { sum += difference * difference / (angle_spread * angle_spread); };
  if (has_a) add(angle(a.model_point.direction, u) - angle(a.data_point.direction, v));
  if (has_b) add(angle(b.model_point.direction, u) - angle(b.data_point.direction, v));
  if (has_a && has_b) {
    add(angle(a.model_point.direction, b.model_point.direction) - angle(a.data_point.direction, b.data_point.direction));
  }
  return sum;
}

// How badly two candidates go together, `log_a` and `log_b` being the logarithms of their radius ratios; infinite when they cannot.
double pair_cost(const Correspondence& a, double log_a, const Correspondence& b, double log_b, const Shape& model, const Shape& data) {
  if (a.model == b.model || a.data == b.data || std::abs(log_a - log_b) > 2 * ratio_limit) return infinite;
  const double straight = (a.model_point.position - b.model_point.position).norm();
  const double straight_data = (a.data_point.position - b.data_point.position).norm();
  const double ratio = std::min(ratio_cost(straight, straight_data, log_a, log_b),
                                ratio_cost(model.inner_distance(a.model, b.model), data.inner_distance(a.data, b.data), log_a, log_b));
  if (ratio == infinite) return infinite;
  const double radii = (log_a - log_b) * (log_a - log_b) / (radius_spread * radius_spread);
  const double spread = 2 * descriptor_spread * descriptor_spread;
  const double descriptors = (a.descriptor_distance * a.descriptor_distance + b.descriptor_distance * b.descriptor_distance) / spread;
  const double reward = std::log(straight / model.diagonal);  // long baselines fix scale and frame better
  return ratio + radii + descriptors + 0.5 * direction_cost(a, b) - reward;
}

// Sine of the angle at which c leaves the line a b: a third point on it would leave the turn about it open.
double offset_from_line(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).normalized().cross(c - a).norm() / std::max((c - a).norm(), (c - b).norm());
}

Seed with_third(int a, int b, const CorrespondenceSet& candidates, const Eigen::MatrixXf& costs) {
  Seed seed{{candidates[a], candidates[b]}, costs(a, b)};
  double best = infinite;
  int third = -1;
  for (int c = 0; c < static_cast<int>(candidates.size()); ++c) {
    const double cost = static_cast<double>(costs(a, c)) + costs(b, c);
    if (cost >= best) continue;
    const double off =
        offset_from_line(candidates[a].model_point.position, candidates[b].model_point.position, candidates[c].model_point.position);
    if (off < 0.15) continue;
    best = cost;
    third = c;
  }
  if (third >= 0) {
    seed.pairs.push_back(candidates[third]);
    seed.cost = (seed.cost + best) / 3;
  }
  return seed;
}

}  // namespace

std::vector<Seed> find_seeds(const CorrespondenceSet& candidates, const Shape& model, const Shape& data) {
  const int count = static_cast<int>(candidates.size());
  Eigen::MatrixXf costs = Eigen::MatrixXf::Constant(count, count, std::numeric_limits<float>::infinity());
  std::vector<double> log_ratio;
  for (const Correspondence& c : candidates) log_ratio.push_back(std::log(c.data_point.radius / c.model_point.radius));
  parallel_for(count, [&](std::size_t b) {
    for (std::size_t a = 0; a < b; ++a) {
      costs(a, b) = static_cast<float>(pair_cost(candidates[a], log_ratio[a], candidates[b], log_ratio[b], model, data));
      costs(b, a) = costs(a, b);
    }
  });
  std::vector<std::tuple<float, int, int>> order;
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      if (std::isfinite(costs(a, b))) order.emplace_back(costs(a, b), a, b);
    }
  }
  std::sort(order.begin(), order.end());
  std::vector<int> uses(count, 0);
  std::vector<Seed> seeds;
  for (const auto& [cost, a, b] : order) {
    if (seeds.size() == seed_count) break;
    if (uses[a] >= uses_of_a_candidate || uses[b] >= uses_of_a_candidate) continue;
    ++uses[a];
    ++uses[b];
    seeds.push_back(with_third(a, b, candidates, costs));
  }
  std::stable_sort(seeds.begin(), seeds.end(), [](const Seed& x, const Seed& y) { return x.cost < y.cost; });
  return seeds;
}

}  // namespace homolog
