// SPDX-License-Identifier: MIT
#include "homolog/match/clique_growth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "match/synthetic_pairs.h"

namespace homolog {
namespace {

using synthetic::candidates;
using synthetic::count_true;
using synthetic::similarity;

const double diagonal = std::sqrt(3.0);  // of the cube in which the points lie

std::vector<std::pair<int, int>> indices(const CorrespondenceSet& set) {
  std::vector<std::pair<int, int>> all;
  for (const auto& c : set) all.emplace_back(c.model, c.data);
  return all;
}

void expect_one_to_one(const CorrespondenceSet& set) {
  std::set<int> model, data;
  for (const auto& c : set) {
    EXPECT_TRUE(model.insert(c.model).second);
    EXPECT_TRUE(data.insert(c.data).second);
  }
}

void expect_true_set(double false_share, Chirality chirality, double bending_limit, int least_true, int most_false) {
  const int truth = 20, count = static_cast<int>(std::lround(truth / (1 - false_share)));
  PaperParams params = paper_preset().paper;
  params.bending_limit = bending_limit;
  const GrownSets grown = grow_quadruples(candidates(truth, count, similarity(chirality, 1.7), 0.1, 11), diagonal, params);
  ASSERT_FALSE(grown.sets.empty());
  EXPECT_GE(count_true(grown.sets[0]), least_true) << "false share " << false_share;
  EXPECT_LE(static_cast<int>(grown.sets[0].size()) - count_true(grown.sets[0]), most_false) << "false share " << false_share;
  for (const auto& set : grown.sets) expect_one_to_one(set);
}

TEST(Sec62, TheTrueSetGrowsAmongFalseCandidates) {
  for (const double false_share : {0.5, 0.7, 0.9}) {
    for (const Chirality chirality : {Chirality::proper, Chirality::mirrored}) expect_true_set(false_share, chirality, 2, 20, 1);
  }
}

// t_Delta = 25 is for bodies that bend: among stray points it takes every second false candidate along, which eq. 9 must then refuse.
TEST(Sec62, ThePublishedLimitAlsoTakesFalseCandidates) {
  expect_true_set(0.5, Chirality::proper, 25, 16, 6);
  expect_true_set(0.9, Chirality::proper, 25, 16, 16);
}

TEST(Sec62, FalseCandidatesAloneGrowSmallSetsOnly) {
  auto all = candidates(20, 200, similarity(Chirality::proper, 1), 0.1, 5);
  all.erase(all.begin(), all.begin() + 20);
  for (const auto& set : grow_quadruples(all, diagonal, paper_preset().paper).sets) EXPECT_LT(set.size(), 10u);
}

TEST(Sec62, SetsAreMaximalAndLargestFirst) {
  const auto grown = grow_quadruples(candidates(12, 60, similarity(Chirality::proper, 1), 0.2, 3), diagonal, PaperParams{});
  ASSERT_GT(grown.sets.size(), 1u);
  for (std::size_t i = 0; i < grown.sets.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE(grown.sets[j].size(), grown.sets[i].size());
      const auto large = indices(grown.sets[j]), small = indices(grown.sets[i]);
      EXPECT_FALSE(std::includes(large.begin(), large.end(), small.begin(), small.end()));
    }
  }
}

TEST(Sec62, ALimitOfBendingKeepsBentCandidatesOut) {
  auto all = candidates(12, 12, similarity(Chirality::proper, 1), 0, 3);
  all[7].data_point.position += Vec3(0.3, 0, 0);
  PaperParams params;
  params.bending_limit = 0.01;
  const auto grown = grow_quadruples(all, diagonal, params);
  ASSERT_FALSE(grown.sets.empty());
  EXPECT_EQ(grown.sets[0].size(), 11u);
  for (const auto& c : grown.sets[0]) EXPECT_NE(c.model, 7);
}

TEST(Sec61, BendingHasNoUnitAndNoScale) {
  const auto set = candidates(8, 8, similarity(Chirality::proper, 1.7), 0.3, 2);
  auto scaled = set;
  for (auto& c : scaled) {
    c.model_point.position *= 100, c.model_point.radius *= 100;
    c.data_point.position *= 0.01, c.data_point.radius *= 0.01;
  }
  const double bending = affine_free_bending(set, diagonal);
  EXPECT_GT(bending, 0.01);
  EXPECT_NEAR(affine_free_bending(scaled, 100 * diagonal), bending, 1e-6 * bending);
}

TEST(Sec61, RadiusAndDirectionTakePartThroughTheShiftedPoints) {
  auto set = candidates(6, 6, similarity(Chirality::proper, 1), 0, 2);
  EXPECT_NEAR(affine_free_bending(set, diagonal), 0, 1e-6);
  auto turned = set;
  turned[0].data_point.direction *= -1;
  EXPECT_GT(affine_free_bending(turned, diagonal), 1);
  turned[0].data_point.direction_length = 0;  // no direction: x alone
  EXPECT_NEAR(affine_free_bending(turned, diagonal), 0, 1e-6);
  auto swollen = set;
  swollen[0].data_point.radius *= 3;
  EXPECT_GT(affine_free_bending(swollen, diagonal), 1);
}

TEST(CliqueGrowth, PointsWithoutDirectionGrowToo) {
  auto all = candidates(20, 60, similarity(Chirality::proper, 1), 0.05, 4);
  for (auto& c : all) {
    if (c.data % 3 == 0) c.data_point.direction_length = 0;
  }
  const auto grown = grow_quadruples(all, diagonal, paper_preset().paper);
  ASSERT_FALSE(grown.sets.empty());
  EXPECT_GE(count_true(grown.sets[0]), 18);
}

TEST(CliqueGrowth, OrderOfCandidatesDoesNotMatter) {
  auto all = candidates(15, 100, similarity(Chirality::proper, 1), 0.1, 6);
  const auto first = grow_quadruples(all, diagonal, PaperParams{});
  std::reverse(all.begin(), all.end());
  const auto second = grow_quadruples(all, diagonal, PaperParams{});
  ASSERT_EQ(first.sets.size(), second.sets.size());
  for (std::size_t i = 0; i < first.sets.size(); ++i) EXPECT_EQ(indices(first.sets[i]), indices(second.sets[i]));
}

TEST(CliqueGrowth, ASearchCutShortIsToldAndRepeats) {
  PaperParams loose;
  loose.pair_tolerance = 0.3;
  loose.direction_angle = 0.8;
  const auto all = candidates(25, 400, similarity(Chirality::proper, 1), 0.3, 8);
  const auto first = grow_quadruples(all, diagonal, loose), second = grow_quadruples(all, diagonal, loose);
  EXPECT_FALSE(first.complete);
  EXPECT_GT(first.quadruples, first.grown);
  ASSERT_EQ(first.sets.size(), second.sets.size());
  for (std::size_t i = 0; i < first.sets.size(); ++i) EXPECT_EQ(indices(first.sets[i]), indices(second.sets[i]));
}

TEST(CliqueGrowth, NothingGrowsFromNothing) { EXPECT_TRUE(grow_quadruples({}, 1, PaperParams{}).sets.empty()); }

}  // namespace
}  // namespace homolog
