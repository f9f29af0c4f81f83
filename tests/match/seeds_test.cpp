// SPDX-License-Identifier: MIT
// Sec. 6.2.1, done differently: pairs of true candidates come first, whatever the similarity.
#include "homolog/match/seeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "fixtures/shapes.h"
#include "match/synthetic_pairs.h"

namespace homolog {
namespace {

struct Clutter {
  Shape model, data;
  CorrespondenceSet candidates;
};

// `truth` true candidates (i, i) and as many false ones as make `count`.
Clutter clutter(int truth, int count, const Similarity& map, unsigned seed) {
  Clutter c;
  c.candidates = synthetic::candidates(truth, count, map, 0.1, seed);
  std::vector<SalientPoint> model(2 * truth), data(2 * truth);
  for (const Correspondence& pair : c.candidates) {
    model[pair.model] = pair.model_point;
    data[pair.data] = pair.data_point;
  }
  c.model = fixtures::bare_shape(model);
  c.data = fixtures::bare_shape(data);
  return c;
}

TEST(Seeds, TheBestAreAllTrueAmongTwiceAsManyFalseCandidates) {
  for (const auto chirality : {Chirality::proper, Chirality::mirrored}) {
    for (const double scale : {0.01, 1.0, 40.0}) {
      const Clutter c = clutter(12, 36, synthetic::similarity(chirality, scale), 7);
      const std::vector<Seed> seeds = find_seeds(c.candidates, c.model, c.data);
      ASSERT_GE(seeds.size(), 12u);
      for (int s = 0; s < 12; ++s) EXPECT_EQ(synthetic::count_true(seeds[s].pairs), 3) << s;  // a seed for every true candidate
    }
  }
}

TEST(Seeds, AreOrderedOneToOneAndUseEachCandidateAsABaseInFew) {
  const Clutter c = clutter(20, 100, synthetic::similarity(Chirality::proper, 2), 3);
  const std::vector<Seed> seeds = find_seeds(c.candidates, c.model, c.data);
  std::map<double, int> uses;  // by descriptor distance, which tells candidates apart
  for (std::size_t s = 0; s < seeds.size(); ++s) {
    const CorrespondenceSet& pairs = seeds[s].pairs;
    if (s > 0) EXPECT_LE(seeds[s - 1].cost, seeds[s].cost);
    for (std::size_t a = 0; a < pairs.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        EXPECT_NE(pairs[a].model, pairs[b].model);
        EXPECT_NE(pairs[a].data, pairs[b].data);
      }
    }
    for (int a = 0; a < 2; ++a) EXPECT_LE(++uses[pairs[a].descriptor_distance], 6);
  }
}

// Four points of a straight chain, and the same chain curled up: only ways along the body keep their lengths.
TEST(Seeds, AgreeAlongABentBody) {
  std::vector<SalientPoint> straight, curled;
  for (int i = 0; i < 4; ++i) {
    straight.push_back({Vec3(i, 0, 0), 0.3, Vec3::UnitX(), 0, 1});
    curled.push_back({Vec3(std::cos(1.5 * i), std::sin(1.5 * i), 0), 0.3, Vec3::UnitX(), 0, 1});
  }
  const Shape model = fixtures::bare_shape(straight);
  Shape data = fixtures::bare_shape(curled);
  const CorrespondenceSet ends = {{0, 0, straight[0], curled[0], 0, 0}, {3, 3, straight[3], curled[3], 0, 0}};
  EXPECT_TRUE(find_seeds(ends, model, data).empty());  // 3 apart against 1.6
  data.inner_distance = model.inner_distance;
  EXPECT_EQ(find_seeds(ends, model, data).size(), 1u);
}

TEST(Seeds, TheThirdPairStandsBesideTheLine) {
  const Similarity map = synthetic::similarity(Chirality::proper, 1);
  CorrespondenceSet candidates;
  std::vector<SalientPoint> model, data;
  for (const Vec3& place : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0.01, 0), Vec3(0.5, 0.6, 0)}) {
    const int i = static_cast<int>(model.size());
    model.push_back({place, 0.1, Vec3::UnitX(), 0, 1});
    data.push_back({map(place), 0.1, Vec3::UnitX(), 0, 1});
    candidates.push_back({i, i, model.back(), data.back(), 0, 0});
  }
  for (const Seed& seed : find_seeds(candidates, fixtures::bare_shape(model), fixtures::bare_shape(data))) {
    ASSERT_EQ(seed.pairs.size(), 3u);
    const bool all_on_the_line = seed.pairs[0].model < 3 && seed.pairs[1].model < 3 && seed.pairs[2].model < 3;
    EXPECT_FALSE(all_on_the_line);
  }
}

double between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// How badly two candidates go together, from the points themselves; infinite when they cannot.
double cost_of(const Correspondence& a, const Correspondence& b, const Shape& model, const Shape& data) {
  const double infinite = std::numeric_limits<double>::infinity();
  const double growth_a = a.data_point.radius / a.model_point.radius, growth_b = b.data_point.radius / b.model_point.radius;
  const double apart = std::abs(std::log(growth_a / growth_b));
  if (a.model == b.model || a.data == b.data || apart > 0.9) return infinite;
  const auto ratio_cost = [&](double here, double there) {
    const double ratio = there / here, off = std::log(ratio / std::sqrt(growth_a * growth_b)) / 0.2;
    return std::max(std::abs(std::log(ratio / growth_a)), std::abs(std::log(ratio / growth_b))) > 0.45 ? infinite : off * off;
  };
  const Vec3 here = b.model_point.position - a.model_point.position, there = b.data_point.position - a.data_point.position;
  const double ratio = std::min(ratio_cost(here.norm(), there.norm()),
                                ratio_cost(model.inner_distance(a.model, b.model), data.inner_distance(a.data, b.data)));
  const auto has_directions = [](const Correspondence& c) {
    return c.model_point.direction_length > 0 && c.data_point.direction_length > 0;
  };
  const Vec3 &ma = a.model_point.direction, &mb = b.model_point.direction, &da = a.data_point.direction, &db = b.data_point.direction;
  double turns = 0;
  if (has_directions(a)) turns += std::pow((between(ma, here) - between(da, there)) / 0.6, 2);
  if (has_directions(b)) turns += std::pow((between(mb, -here) - between(db, -there)) / 0.6, 2);
  if (has_directions(a) && has_directions(b)) turns += std::pow((between(ma, mb) - between(da, db)) / 0.6, 2);
  const double descriptors = (std::pow(a.descriptor_distance, 2) + std::pow(b.descriptor_distance, 2)) / 18;
  return ratio + std::pow(apart / 0.3, 2) + descriptors + turns / 2 - std::log(here.norm() / model.diagonal);
}

/// The third candidate that costs least with both and stands beside their line.
void add_third(Seed& seed, const Clutter& c) {
  const Vec3 from = seed.pairs[0].model_point.position, to = seed.pairs[1].model_point.position;
  const Correspondence* third = nullptr;
  double best = std::numeric_limits<double>::infinity();
  for (const Correspondence& candidate : c.candidates) {
    const Vec3& place = candidate.model_point.position;
    const double off = (to - from).normalized().cross(place - from).norm() / std::max((place - from).norm(), (place - to).norm());
    if (candidate.model == seed.pairs[0].model || candidate.model == seed.pairs[1].model || off < 0.15) continue;
    const double cost = cost_of(seed.pairs[0], candidate, c.model, c.data) + cost_of(seed.pairs[1], candidate, c.model, c.data);
    if (cost < best) best = cost, third = &candidate;
  }
  if (!third) return;
  seed.pairs.push_back(*third);
  seed.cost = (seed.cost + best) / 3;
}

// All pairs of candidates by their cost, each candidate in at most six.
std::vector<Seed> seeds_of_all_pairs(const Clutter& c) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> order;
  for (std::size_t b = 0; b < c.candidates.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      const double cost = cost_of(c.candidates[a], c.candidates[b], c.model, c.data);
      if (std::isfinite(cost)) order.emplace_back(cost, a, b);
    }
  }
  std::sort(order.begin(), order.end());
  std::vector<int> uses(c.candidates.size(), 0);
  std::vector<Seed> seeds;
  for (const auto& [cost, a, b] : order) {
    if (seeds.size() == 300 || uses[a] == 6 || uses[b] == 6) continue;
    ++uses[a], ++uses[b];
    seeds.push_back({{c.candidates[a], c.candidates[b]}, cost});
    add_third(seeds.back(), c);
  }
  return seeds;
}

/// By their first two pairs: seeds of the same three pairs cost the same, so that rounding orders them.
std::vector<Seed> by_base(std::vector<Seed> seeds) {
  const auto key = [](const Seed& seed) {
    const Correspondence &a = seed.pairs[0], &b = seed.pairs[1];
    return std::tuple(a.model, a.data, a.descriptor_distance, b.model, b.data, b.descriptor_distance);
  };
  std::sort(seeds.begin(), seeds.end(), [&](const Seed& x, const Seed& y) { return key(x) < key(y); });
  return seeds;
}

TEST(Seeds, AreThoseOfTryingAllPairs) {
  for (const int count : {30, 200}) {  // with 200 candidates there are more than 300 seeds
    Clutter c = clutter(count / 5, count, synthetic::similarity(Chirality::mirrored, 3), 11);
    for (Correspondence& candidate : c.candidates) {
      if (candidate.data % 3 == 0) candidate.data_point.direction_length = 0;
    }
    for (Eigen::Index i = 0; i < c.data.inner_distance.rows(); ++i) {
      for (Eigen::Index j = 0; j < i; ++j)
        c.data.inner_distance(i, j) = c.data.inner_distance(j, i) *= 1 + 0.1 * static_cast<double>((i + j) % 7);
    }
    const std::vector<Seed> found = by_base(find_seeds(c.candidates, c.model, c.data)), expected = by_base(seeds_of_all_pairs(c));
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t s = 0; s < found.size(); ++s) {
      ASSERT_NEAR(found[s].cost, expected[s].cost, 1e-5) << s;
      ASSERT_EQ(found[s].pairs.size(), expected[s].pairs.size()) << s;
      for (std::size_t i = 0; i < found[s].pairs.size(); ++i) {
        EXPECT_EQ(found[s].pairs[i].model, expected[s].pairs[i].model) << s;
        EXPECT_EQ(found[s].pairs[i].data, expected[s].pairs[i].data) << s;
      }
    }
  }
}

TEST(Seeds, NoCandidatesNoSeeds) {
  const Shape empty = fixtures::bare_shape({});
  EXPECT_TRUE(find_seeds({}, empty, empty).empty());
}

}  // namespace
}  // namespace homolog
