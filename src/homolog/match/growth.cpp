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

// A candidate that may still join, with what its cost asks first: all of them are looked at for every pair that joins.
struct FreeCandidate {
  Vec3 place;     // of its data point
  double unlike;  // what its descriptors cost
  const Correspondence* pair;
  int model, data;
};

// By model point, as the candidates are; without those that cost too much wherever they lie.
std::vector<FreeCandidate> free_candidates(const CorrespondenceSet& candidates) {
  std::vector<FreeCandidate> free;
  for (const Correspondence& c : candidates) {
    const double descriptor = c.descriptor_distance / descriptor_spread, unlike = 0.5 * descriptor * descriptor;
    if (unlike < cost_limit) free.push_back({c.data_point.position, unlike, &c, c.model, c.data});
  }
  return free;
}

struct Grower {
  double bending_length;  // bending share times the model's diagonal
  Chirality chirality;
  std::vector<Vec3> places;
  std::vector<FreeCandidate> free;
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
    std::erase_if(free, [&](const FreeCandidate& other) { return other.model == c.model || other.data == c.data; });
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

  // Negative log likelihood, up to a constant, in units where each part is about 1 when the pair is right. What is not below `limit` may
  // be told too low: most are far beyond it by their place.
  double cost(const FreeCandidate& candidate, const Expectation& expected, double limit) const {
    const double place = (candidate.place - expected.place).squaredNorm() / (3 * expected.variance);
    if (place + candidate.unlike >= limit) return limit;
    const Correspondence& c = *candidate.pair;
    const double log_radius = std::log(c.data_point.radius / (free_part.scale * c.model_point.radius)) / radius_spread;
    const double sum = place + log_radius * log_radius + candidate.unlike;
    if (sum >= limit || !has_directions(c)) return sum;
    const Vec3 direction = (spline.at(tip_of(c), free_part) - expected.place).normalized();
    const double angle = std::acos(std::clamp(direction.dot(c.data_point.direction), -1.0, 1.0)) / angle_spread;
    return sum + 0.5 * angle * angle;
  }

  // The likeliest of the free candidates, or nullptr when all cost too much.
  const Correspondence* likeliest(double& cost_of_it) const {
    const Correspondence* best = nullptr;
    cost_of_it = cost_limit;
    int last_model = -1;
    Expectation expected;
    for (const FreeCandidate& candidate : free) {
      if (candidate.model != last_model) expected = expect(*candidate.pair);
      last_model = candidate.model;
      const double now = cost(candidate, expected, cost_of_it);
      if (now < cost_of_it) {
        cost_of_it = now;
        best = candidate.pair;
      }
    }
    return best;
  }
};

}  // namespace

GrownSet grow_seed(const Seed& seed, Chirality chirality, const CorrespondenceSet& candidates, const Shape& model, double bending) {
  Grower grower{bending * model.diagonal, chirality, places_of(candidates, model.points.size()), free_candidates(candidates)};
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
