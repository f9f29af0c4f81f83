// SPDX-License-Identifier: MIT
#include "homolog/match/seeds.h"

#include <algorithm>
#include <cmath>
#include <functional>
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

// What of every two points of a shape pairs of candidates ask for, point by point.
struct PointPairs {
  Eigen::MatrixXd log_straight, log_inner;  // of their distances; not finite where they have none
  Eigen::MatrixXd turned, between;          // angle between the direction of the first and the way to the second, and of both directions
};

double angle(const Vec3& a, const Vec3& b) { return std::acos(std::clamp(a.dot(b), -1.0, 1.0)); }

PointPairs pairs_of(const std::vector<SalientPoint>& points, const Eigen::MatrixXd& inner_distance) {
  const auto n = static_cast<Eigen::Index>(points.size());
  PointPairs pairs{Eigen::MatrixXd(n, n), inner_distance.array().log(), Eigen::MatrixXd(n, n), Eigen::MatrixXd(n, n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const Vec3 way = points[j].position - points[i].position;
      pairs.log_straight(i, j) = std::log(way.norm());
      pairs.turned(i, j) = angle(points[i].direction, way.normalized());
      pairs.between(i, j) = angle(points[i].direction, points[j].direction);
    }
  }
  return pairs;
}

// A candidate, and what of it alone pairs ask for.
struct Half {
  int model, data;
  double log_ratio;  // of the radii
  double descriptor;
  bool directed;
};

// Squared disagreement of a distance ratio with the two radius ratios, infinite beyond the limit. All by their logarithms.
double ratio_cost(double model_distance, double data_distance, double log_a, double log_b) {
  const double ratio = data_distance - model_distance;
  if (!std::isfinite(ratio)) return infinite;
  const double worst = std::max(std::abs(ratio - log_a), std::abs(ratio - log_b));
  const double mean = ratio - 0.5 * (log_a + log_b);
  return worst > ratio_limit ? infinite : mean * mean / (ratio_spread * ratio_spread);
}

// Disagreement of the directions p with the baseline and with each other.
double direction_cost(const Half& a, const Half& b, const PointPairs& model, const PointPairs& data) {
  double sum = 0;
  const auto add = [&](double difference) { sum += difference * difference / (angle_spread * angle_spread); };
  if (a.directed) add(model.turned(a.model, b.model) - data.turned(a.data, b.data));
  if (b.directed) add(model.turned(b.model, a.model) - data.turned(b.data, a.data));
  if (a.directed && b.directed) add(model.between(a.model, b.model) - data.between(a.data, b.data));
  return sum;
}

// How badly two candidates go together; infinite when they cannot.
double pair_cost(const Half& a, const Half& b, const PointPairs& model, const PointPairs& data, double log_diagonal) {
  if (a.model == b.model || a.data == b.data || std::abs(a.log_ratio - b.log_ratio) > 2 * ratio_limit) return infinite;
  const double straight = model.log_straight(a.model, b.model);
  const double ratio = std::min(ratio_cost(straight, data.log_straight(a.data, b.data), a.log_ratio, b.log_ratio),
                                ratio_cost(model.log_inner(a.model, b.model), data.log_inner(a.data, b.data), a.log_ratio, b.log_ratio));
  if (ratio == infinite) return infinite;
  const double radii = (a.log_ratio - b.log_ratio) * (a.log_ratio - b.log_ratio) / (radius_spread * radius_spread);
  const double descriptors = (a.descriptor * a.descriptor + b.descriptor * b.descriptor) / (2 * descriptor_spread * descriptor_spread);
  const double reward = straight - log_diagonal;  // long baselines fix scale and frame better
  return ratio + radii + descriptors + 0.5 * direction_cost(a, b, model, data) - reward;
}

// Of a and b, a < b, at (a, b).
Eigen::MatrixXf costs_of(const CorrespondenceSet& candidates, const Shape& model, const Shape& data) {
  const PointPairs here = pairs_of(model.points, model.inner_distance), there = pairs_of(data.points, data.inner_distance);
  std::vector<Half> halves;
  for (const Correspondence& c : candidates) {
    halves.push_back({c.model, c.data, std::log(c.data_point.radius / c.model_point.radius), c.descriptor_distance, has_directions(c)});
  }
  Eigen::MatrixXf costs(halves.size(), halves.size());
  parallel_for(halves.size(), [&](std::size_t b) {
    for (std::size_t a = 0; a < b; ++a) {
      costs(a, b) = static_cast<float>(pair_cost(halves[a], halves[b], here, there, std::log(model.diagonal)));
    }
  });
  return costs;
}

// Sine of the angle at which c leaves the line a b: a third point on it would leave the turn about it open.
double offset_from_line(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).normalized().cross(c - a).norm() / std::max((c - a).norm(), (c - b).norm());
}

Seed with_third(int a, int b, const CorrespondenceSet& candidates, const Eigen::MatrixXf& costs) {
  const auto cost_of = [&](int x, int y) { return x == y ? infinite : static_cast<double>(costs(std::min(x, y), std::max(x, y))); };
  Seed seed{{candidates[a], candidates[b]}, costs(a, b)};
  double best = infinite;
  int third = -1;
  for (int c = 0; c < static_cast<int>(candidates.size()); ++c) {
    const double cost = cost_of(a, c) + cost_of(b, c);
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
  const Eigen::MatrixXf costs = costs_of(candidates, model, data);
  std::vector<std::tuple<float, int, int>> order;
  for (int b = 0; b < count; ++b) {
    for (int a = 0; a < b; ++a) {
      if (std::isfinite(costs(a, b))) order.emplace_back(costs(a, b), a, b);
    }
  }
  std::make_heap(order.begin(), order.end(), std::greater<>());  // few of very many are looked at
  std::vector<int> uses(count, 0);
  std::vector<Seed> seeds;
  for (auto end = order.end(); end != order.begin() && seeds.size() < seed_count;) {
    std::pop_heap(order.begin(), end--, std::greater<>());
    const auto [cost, a, b] = *end;
    if (uses[a] >= uses_of_a_candidate || uses[b] >= uses_of_a_candidate) continue;
    ++uses[a];
    ++uses[b];
    seeds.push_back(with_third(a, b, candidates, costs));
  }
  std::stable_sort(seeds.begin(), seeds.end(), [](const Seed& x, const Seed& y) { return x.cost < y.cost; });
  return seeds;
}

}  // namespace homolog
