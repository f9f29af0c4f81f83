// SPDX-License-Identifier: MIT
// Sec. 6.2.2, done differently: from one seed the true set is recovered among false candidates.
#include "homolog/match/growth.h"

#include <gtest/gtest.h>

#include <set>

#include "fixtures/shapes.h"
#include "match/synthetic_pairs.h"

namespace homolog {
namespace {

constexpr int truth = 16;

Shape sized_shape() {
  Shape shape = fixtures::bare_shape(std::vector<SalientPoint>(2 * truth));
  shape.diagonal = std::sqrt(3.0);  // of the unit cube that holds the points
  return shape;
}

GrownSet grow(const CorrespondenceSet& candidates, Chirality chirality, double bending = 0.015) {
  const Seed seed{{candidates[0], candidates[1], candidates[2]}, 0};
  return grow_seed(seed, chirality, candidates, sized_shape(), bending);
}

// Candidates ordered by model index, as find_candidates gives them, after the seed's three.
CorrespondenceSet half_false(const Similarity& map, double noise, unsigned seed) {
  CorrespondenceSet candidates = synthetic::candidates(truth, 2 * truth, map, noise, seed);
  std::stable_sort(candidates.begin() + 3, candidates.end(), [](const auto& a, const auto& b) { return a.model < b.model; });
  return candidates;
}

TEST(Sec622, TheTrueSetGrowsFromASeedAmongHalfFalseCandidates) {
  for (const auto chirality : {Chirality::proper, Chirality::mirrored}) {
    for (const double scale : {0.01, 1.0, 100.0}) {
      const GrownSet grown = grow(half_false(synthetic::similarity(chirality, scale), 0.1, 5), chirality);
      EXPECT_EQ(grown.chirality, chirality);
      EXPECT_EQ(grown.pairs.size(), static_cast<std::size_t>(truth));
      EXPECT_EQ(synthetic::count_true(grown.pairs), truth);
      EXPECT_NEAR(grown.spline.similarity.scale / scale, 1, 0.05);
      EXPECT_EQ(grown.spline.similarity.rotation.determinant() < 0, chirality == Chirality::mirrored);
    }
  }
}

TEST(Growth, TheWrongChiralityGrowsLess) {
  const CorrespondenceSet candidates = half_false(synthetic::similarity(Chirality::mirrored, 3), 0.1, 5);
  EXPECT_LT(grow(candidates, Chirality::proper).score, 0.5 * grow(candidates, Chirality::mirrored).score);
}

TEST(Growth, SetsAreOneToOne) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const CorrespondenceSet candidates = synthetic::candidates(truth, 20 * truth, synthetic::similarity(Chirality::proper, 1), 0.3, seed);
    std::set<int> models, data;
    for (const Correspondence& c : grow(candidates, Chirality::proper, 0.1).pairs) {
      EXPECT_TRUE(models.insert(c.model).second);
      EXPECT_TRUE(data.insert(c.data).second);
    }
  }
}

TEST(Sec61, ABentSetGrowsOnlyAsFarAsBendingAllows) {
  CorrespondenceSet candidates = half_false(Similarity(), 0, 9);
  for (Correspondence& c : candidates) {  // an arc of about a radian; the seed's pairs as well
    const double angle = c.data_point.position.x();
    c.data_point.position = Vec3(std::sin(angle), c.data_point.position.y() + 1 - std::cos(angle), c.data_point.position.z());
    c.data_point.direction_length = 0;
  }
  EXPECT_GT(synthetic::count_true(grow(candidates, Chirality::proper, 0.015).pairs), truth * 3 / 4);
  EXPECT_LT(synthetic::count_true(grow(candidates, Chirality::proper, 0.0001).pairs), truth * 3 / 4);
}

TEST(Growth, ScoreCountsPairsLessTheirCosts) {
  const GrownSet exact = grow(half_false(synthetic::similarity(Chirality::proper, 1), 0, 5), Chirality::proper);
  const GrownSet noisy = grow(half_false(synthetic::similarity(Chirality::proper, 1), 0.3, 5), Chirality::proper);
  EXPECT_LT(exact.score, truth);  // 0.5 for each of the seed, at most 1 for each that joins
  EXPECT_GT(exact.score, 0.9 * (truth - 1.5));
  EXPECT_GT(exact.score, noisy.score);
}

}  // namespace
}  // namespace homolog
