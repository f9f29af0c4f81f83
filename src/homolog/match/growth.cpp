// SPDX-License-Identifier: MIT
#include "homolog/match/growth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "homolog/match/candidates.h"

namespace homolog {
namespace {

constexpr double cost_limit = 4;        // of a joining correspondence; about two standard deviations in all
constexpr double place_nugget = 0.3;    // r: how well a salient point is localised
constexpr double direction_nugget = 1;  // r
constexpr double radius_spread = 0.2;   // of log r
constexpr double angle_spread = 0.6;    // radians
constexpr std::size_t few_pairs = 6;    // directions help to lay the spline only while it has so few

bool has_directions(const Correspondence& c) { return c.model_point.direction_length > 0 && c.data_point.direction_length > 0; }

Vec3 tip(const SalientPoint& point) { return point.position + point.radius * point.direction; }  // y = x + r p (Sec. 6.1)

struct Prediction {
  SourceSystem system;
  ThinPlateSpline spline;
};

Prediction predict_from(const CorrespondenceSet& pairs, Chirality chirality) {
  std::vector<Vec3> sources, targets;
  std::vector<double> nugget;
  const auto add = [&](const Vec3& source, const Vec3& target, double slack) {
    sources.push_back(source);
    targets.push_back(target);
    nugget.push_back(slack);
  };
  for (const Correspondence& c : pairs) {
    const double r = c.model_point.radius;
    add(c.model_point.position, c.data_point.position, place_nugget * r);
    if (pairs.size() < few_pairs && has_directions(c)) add(tip(c.model_point), tip(c.data_point), direction_nugget * r);
  }
  SourceSystem system(std::move(sources), nugget);
  ThinPlateSpline spline = ThinPlateSpline::similarity_free(system, targets, chirality);
  return {std::move(system), std::move(spline)};
}

// Where a free model point should be found again.
struct Expectation {
  Vec3 place = Vec3::Zero();
  double variance = 1;  // of one coordinate, data units squared
};

struct Grower {
  const CorrespondenceSet& candidates;
  double bending_length;  // bending share times the model's diagonal
  Chirality chirality;
  CorrespondenceSet pairs;
  std::vector<char> model_used, data_used;

  void join(const Correspondence& c) {
    pairs.push_back(c);
    model_used[c.model] = data_used[c.data] = 1;
  }

  Expectation expect(const Prediction& prediction, const SalientPoint& point) const {
    const double s = prediction.spline.similarity.scale;
    const Vec3 place = prediction.spline(point.position);
    return {place, s * s * bending_length * (prediction.system.variance(point.position) + place_nugget * point.radius)};
  }

  // Negative log likelihood of c, up to a constant, in units where each part is about 1 when c is right. What is not below `limit` may be
  // told too low: most are far beyond it by their place.
  double cost(const Correspondence& c, const Expectation& expected, const Prediction& prediction, double limit) const {
    const double place = (c.data_point.position - expected.place).squaredNorm() / (3 * expected.variance);
    const double descriptor = c.descriptor_distance / descriptor_spread, unlike = 0.5 * descriptor * descriptor;
    if (place + unlike >= limit) return limit;
    const double log_radius = std::log(c.data_point.radius / (prediction.spline.similarity.scale * c.model_point.radius)) / radius_spread;
    const double sum = place + log_radius * log_radius + unlike;
    if (sum >= limit || !has_directions(c)) return sum;
    const Vec3 direction = (prediction.spline(tip(c.model_point)) - expected.place).normalized();
    const double angle = std::acos(std::clamp(direction.dot(c.data_point.direction), -1.0, 1.0)) / angle_spread;
    return sum + 0.5 * angle * angle;
  }

  // The likeliest free candidate, or nullptr when all cost too much.
  const Correspondence* likeliest(const Prediction& prediction, double& cost_of_it) const {
    const Correspondence* best = nullptr;
    cost_of_it = cost_limit;
    int last_model = -1;
    Expectation expected;
    for (const Correspondence& c : candidates) {
      if (model_used[c.model] || data_used[c.data]) continue;
      if (c.model != last_model) expected = expect(prediction, c.model_point);
      last_model = c.model;
      const double now = cost(c, expected, prediction, cost_of_it);
      if (now < cost_of_it) {
        cost_of_it = now;
        best = &c;
      }
    }
    return best;
  }
};

}  // namespace

GrownSet grow_seed(const Seed& seed, Chirality chirality, const CorrespondenceSet& candidates, const Shape& model, const Shape& data,
                   double bending) {
  Grower grower{
      candidates, bending * model.diagonal, chirality, {}, std::vector<char>(model.points.size()), std::vector<char>(data.points.size())};
  for (const Correspondence& c : seed.pairs) grower.join(c);
  GrownSet grown;
  grown.chirality = chirality;
  grown.score = 0.5 * static_cast<double>(seed.pairs.size());
  while (true) {
    const Prediction prediction = predict_from(grower.pairs, chirality);
    grown.spline = prediction.spline;
    if (!(prediction.spline.similarity.scale > 0)) break;
    double cost = 0;
    const Correspondence* next = grower.likeliest(prediction, cost);
    if (next == nullptr) break;
    grower.join(*next);
    grown.score += 1 - cost / cost_limit;
  }
  grown.pairs = std::move(grower.pairs);
  return grown;
}

}  // namespace homolog
