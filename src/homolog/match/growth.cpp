// SPDX-License-Identifier: MIT
#include "homolog/match/growth.h"

#include <algorithm>
#include <cmath>

#include "homolog/match/candidates.h"
#include "homolog/match/growing_spline.h"

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

// Numbers in places_of().
Eigen::Index position_of(const Correspondence& c) { return Eigen::Index{2} * c.model; }
Eigen::Index tip_of(const Correspondence& c) { return position_of(c) + 1; }

// What a correspondence demands of the spline, at a place of places_of().
struct Constraint {
  Eigen::Index place;
  Vec3 source, target;
  double nugget;
};

std::vector<Constraint> constraints_of(const Correspondence& c, bool with_direction) {
  const SalientPoint &x = c.model_point, &y = c.data_point;
  std::vector<Constraint> constraints{{position_of(c), x.position, y.position, place_nugget * x.radius}};
  if (with_direction && has_directions(c)) constraints.push_back({tip_of(c), tip(x), tip(y), direction_nugget * x.radius});
  return constraints;
}

// Where the spline is asked: at the position and the tip of each of `count` model points that are candidates.
std::vector<Vec3> places_of(const CorrespondenceSet& candidates, std::size_t count) {
  std::vector<Vec3> places(2 * count, Vec3::Zero());
  for (const Correspondence& c : candidates) {
    places[position_of(c)] = c.model_point.position;
    places[tip_of(c)] = tip(c.model_point);
  }
  return places;
}

ThinPlateSpline spline_of(const CorrespondenceSet& pairs, Chirality chirality) {
  std::vector<Vec3> sources, targets;
  std::vector<double> nugget;
  for (const Correspondence& pair : pairs) {
    for (const Constraint& constraint : constraints_of(pair, pairs.size() < few_pairs)) {
      sources.push_back(constraint.source);
      targets.push_back(constraint.target);
      nugget.push_back(constraint.nugget);
    }
  }
  return ThinPlateSpline::similarity_free(SourceSystem(std::move(sources), nugget), targets, chirality);
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
  std::vector<Vec3> places;
  std::vector<char> model_used, data_used;
  CorrespondenceSet pairs = {};
  GrowingSpline spline = {places, chirality};
  Similarity free_part = {};

  void constrain(const Correspondence& c) {
    for (const Constraint& constraint : constraints_of(c, pairs.size() < few_pairs)) {
      spline.add(constraint.place, constraint.target, constraint.nugget);
    }
  }

  void join(const Correspondence& c) {
    pairs.push_back(c);
    model_used[c.model] = data_used[c.data] = 1;
    if (pairs.size() == few_pairs) {  // without the directions from here on
      spline = GrowingSpline(places, chirality);
      for (const Correspondence& pair : pairs) constrain(pair);
    } else {
      constrain(c);
    }
    free_part = spline.free_part();
  }

  Expectation expect(const Correspondence& c) const {
    const double s = free_part.scale, variance = spline.variance(position_of(c)) + place_nugget * c.model_point.radius;
    return {spline.at(position_of(c), free_part), s * s * bending_length * variance};
  }

  // Negative log likelihood of c, up to a constant, in units where each part is about 1 when c is right. What is not below `limit` may be
  // told too low: most are far beyond it by their place.
  double cost(const Correspondence& c, const Expectation& expected, double limit) const {
    const double place = (c.data_point.position - expected.place).squaredNorm() / (3 * expected.variance);
    const double descriptor = c.descriptor_distance / descriptor_spread, unlike = 0.5 * descriptor * descriptor;
    if (place + unlike >= limit) return limit;
    const double log_radius = std::log(c.data_point.radius / (free_part.scale * c.model_point.radius)) / radius_spread;
    const double sum = place + log_radius * log_radius + unlike;
    if (sum >= limit || !has_directions(c)) return sum;
    const Vec3 direction = (spline.at(tip_of(c), free_part) - expected.place).normalized();
    const double angle = std::acos(std::clamp(direction.dot(c.data_point.direction), -1.0, 1.0)) / angle_spread;
    return sum + 0.5 * angle * angle;
  }

  // The likeliest free candidate, or nullptr when all cost too much.
  const Correspondence* likeliest(double& cost_of_it) const {
    const Correspondence* best = nullptr;
    cost_of_it = cost_limit;
    int last_model = -1;
    Expectation expected;
    for (const Correspondence& c : candidates) {
      if (model_used[c.model] || data_used[c.data]) continue;
      if (c.model != last_model) expected = expect(c);
      last_model = c.model;
      const double now = cost(c, expected, cost_of_it);
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
  const std::size_t count = model.points.size();
  Grower grower{candidates,
                bending * model.diagonal,
                chirality,
                places_of(candidates, count),
                std::vector<char>(count),
                std::vector<char>(data.points.size())};
  for (const Correspondence& c : seed.pairs) grower.join(c);
  GrownSet grown;
  grown.chirality = chirality;
  grown.score = 0.5 * static_cast<double>(seed.pairs.size());
  double cost = 0;
  while (grower.free_part.scale > 0) {
    const Correspondence* next = grower.likeliest(cost);
    if (next == nullptr) break;
    grower.join(*next);
    grown.score += 1 - cost / cost_limit;
  }
  grown.spline = spline_of(grower.pairs, chirality);
  grown.pairs = std::move(grower.pairs);
  return grown;
}

}  // namespace homolog
