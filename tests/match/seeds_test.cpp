// SPDX-License-Identifier: MIT
// Sec. 6.2.1, done differently: pairs of true candidates come first, whatever the similarity.
#include "homolog/match/seeds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

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

TEST(Seeds, NoCandidatesNoSeeds) {
  const Shape empty = fixtures::bare_shape({});
  EXPECT_TRUE(find_seeds({}, empty, empty).empty());
}

}  // namespace
}  // namespace homolog
