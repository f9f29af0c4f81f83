// SPDX-License-Identifier: MIT
#include "homolog/match/quadruples.h"

#include <gtest/gtest.h>

#include <cmath>

#include "match/synthetic_pairs.h"

namespace homolog {
namespace {

using synthetic::candidates;
using synthetic::count_true;
using synthetic::similarity;

PaperParams printed() { return paper_preset().paper; }

std::array<Correspondence, 4> true_quadruple(const Similarity& map, unsigned seed = 3) {
  const auto all = candidates(4, 4, map, 0, seed);
  return {all[0], all[1], all[2], all[3]};
}

TEST(AppA, WeightComparesDistancesInRadii) {
  Correspondence p, q;
  p.model = p.data = 0, q.model = q.data = 1;
  p.model_point.radius = p.data_point.radius = 1;
  q.model_point.radius = q.data_point.radius = 2;
  q.model_point.position = Vec3(6, 0, 0);
  q.data_point.position = Vec3(0, 7, 0);
  EXPECT_NEAR(pair_mismatch(p, q, PairTest::printed), 1, 1e-12);  // max(|6/2 - 7/2|, |6/1 - 7/1|)
  EXPECT_NEAR(pair_mismatch(p, q, PairTest::proportions), std::log(7.0 / 6), 1e-12);
}

TEST(AppA, SimilarShapesHaveTheSameProportions) {
  const auto Q = true_quadruple(similarity(Chirality::proper, 2.5));
  for (const PairTest test : {PairTest::printed, PairTest::proportions}) {
    EXPECT_NEAR(pair_mismatch(Q[0], Q[1], test), 0, 1e-9);
    EXPECT_NEAR(pair_mismatch(Q[2], Q[3], test), 0, 1e-9);
  }
}

TEST(AppA, ThePrintedWeightDemandsMoreOfFarPairs) {
  Correspondence p, q;
  p.model = p.data = 0, q.model = q.data = 1;
  p.model_point.radius = p.data_point.radius = q.model_point.radius = q.data_point.radius = 1;
  for (const double distance : {5.0, 50.0}) {  // the same 2 % of difference
    q.model_point.position = Vec3(distance, 0, 0), q.data_point.position = Vec3(1.02 * distance, 0, 0);
    EXPECT_EQ(pair_mismatch(p, q, PairTest::printed) < 0.4, distance == 5);
    EXPECT_NEAR(pair_mismatch(p, q, PairTest::proportions), std::log(1.02), 1e-12);
  }
}

TEST(AppA, CorrespondencesThatShareAPointNeverMeet) {
  auto Q = true_quadruple(similarity(Chirality::proper, 1));
  Q[1].data = Q[0].data;
  EXPECT_TRUE(std::isinf(pair_mismatch(Q[0], Q[1], PairTest::printed)));
}

TEST(AppA, TheAffineMapTakesThePositionsOntoEachOther) {
  const Similarity map = similarity(Chirality::mirrored, 1.4);
  auto Q = true_quadruple(map);
  const auto A = affine_map(Q);
  ASSERT_TRUE(A);
  EXPECT_LT((A->leftCols<3>() - map.scale * map.rotation).norm(), 1e-9);
  EXPECT_LT((A->col(3) - map.shift).norm(), 1e-8);
  for (auto& c : Q) c.model_point.position.z() = 0;
  EXPECT_FALSE(affine_map(Q));
  EXPECT_EQ(quadruple_score(Q, printed()), 0);
}

TEST(AppA, InconsistentDirectionsAreDiscarded) {
  auto Q = true_quadruple(similarity(Chirality::proper, 1.4));
  const Mat3 A = affine_map(Q)->leftCols<3>();
  EXPECT_NEAR(direction_mismatch(Q, A, 1), 0, 1e-6);
  EXPECT_NEAR(quadruple_score(Q, printed()), std::exp(-0.5 * std::pow(0.9 / printed().descriptor_spread, 2)), 0.3);
  Q[2].data_point.direction = Eigen::AngleAxisd(0.31, Q[2].data_point.direction.unitOrthogonal()) * Q[2].data_point.direction;
  EXPECT_NEAR(direction_mismatch(Q, A, 1), 0.31, 1e-6);
  EXPECT_EQ(quadruple_score(Q, printed()), 0);
}

TEST(AppA, AMissingDirectionSaysNeitherYesNorNo) {
  auto Q = true_quadruple(similarity(Chirality::proper, 1.4));
  Q[1].data_point.direction_length = 0;
  Q[1].data_point.direction *= -1;
  const double known = quadruple_score(true_quadruple(similarity(Chirality::proper, 1.4)), printed());
  EXPECT_NEAR(quadruple_score(Q, printed()), known / 2, 1e-6);
}

TEST(AppB, WorseDescriptorsScoreLessAgainstThePrintedSign) {
  auto Q = true_quadruple(similarity(Chirality::proper, 1));
  for (auto& c : Q) c.descriptor_distance = 0;
  EXPECT_NEAR(quadruple_score(Q, printed()), 1, 1e-6);
  Q[0].descriptor_distance = printed().descriptor_spread;
  EXPECT_NEAR(quadruple_score(Q, printed()), std::exp(-0.5), 1e-6);
}

TEST(AppB, StretchedMapsAreExcluded) {
  auto Q = true_quadruple({});
  const auto stretch = [&](double factor) {
    for (auto& c : Q) {
      c.data_point.position = c.model_point.position.cwiseProduct(Vec3(factor, 1, 1));
      c.data_point.direction = c.model_point.direction.cwiseProduct(Vec3(factor, 1, 1)).normalized();
    }
    return quadruple_score(Q, printed());
  };
  EXPECT_GT(stretch(6), 0);  // 1/k = 0.167 > t_k = 0.15
  EXPECT_EQ(stretch(7), 0);
}

void expect_truth_first(double false_share, Chirality chirality) {
  const int truth = 20, count = static_cast<int>(std::lround(truth / (1 - false_share)));
  const auto all = candidates(truth, count, similarity(chirality, 1.7), 0.1, 11);
  const Quadruples found = find_quadruples(all, 50, printed());
  ASSERT_FALSE(found.best.empty()) << "false share " << false_share;
  EXPECT_TRUE(found.complete);
  EXPECT_EQ(count_true({found.best[0].pairs.begin(), found.best[0].pairs.end()}), 4) << "false share " << false_share;
  for (std::size_t i = 1; i < found.best.size(); ++i) EXPECT_GE(found.best[i - 1].score, found.best[i].score);
}

TEST(AppB, TheBestQuadrupleIsTrueAmongFalseCandidates) {
  for (const double false_share : {0.5, 0.7, 0.9}) {
    expect_truth_first(false_share, Chirality::proper);
    expect_truth_first(false_share, Chirality::mirrored);
  }
}

TEST(Quadruples, FewCandidatesGiveNone) {
  EXPECT_TRUE(find_quadruples({}, 10, printed()).best.empty());
  EXPECT_TRUE(find_quadruples(candidates(3, 3, {}, 0, 1), 10, printed()).best.empty());
}

}  // namespace
}  // namespace homolog
