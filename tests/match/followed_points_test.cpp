// SPDX-License-Identifier: MIT
// Points of the model that the map follows where the data has no salient point of its own.
#include "homolog/match/followed_points.h"

#include <gtest/gtest.h>

#include "fixtures/shapes.h"
#include "homolog/match/candidates.h"

namespace homolog {
namespace {

using namespace fixtures;

constexpr double merit = 0.5;

Cloth laid_on_itself(const homolog::Similarity& map = {}) {
  ThinPlateSpline spline;
  spline.similarity = map;
  spline.affine << map.scale * map.rotation, map.shift;
  return lay_cloth(described_hand().body, spline, Chirality::proper);
}

CorrespondenceSet followed(const Cloth& cloth, const CorrespondenceSet& rated = {}) {
  return followed_pairs(rated, cloth, merit, described_hand().diagonal, described_hand(), described_hand());
}

Correspondence pair_of(int i) { return {i, i, described_hand().points[i], described_hand().points[i], 0, 1}; }

TEST(FollowedPoints, LieWhereTheClothLaysThem) {
  const homolog::Similarity map{1.5, Eigen::AngleAxisd(0.4, Vec3::UnitX()).toRotationMatrix(), Vec3(1, 2, 3)};
  const CorrespondenceSet pairs = followed(laid_on_itself(map));
  ASSERT_EQ(pairs.size(), described_hand().points.size());
  for (const Correspondence& c : pairs) {
    EXPECT_LT((c.data_point.position - map(c.model_point.position)).norm(), 1e-9);
    EXPECT_NEAR(c.data_point.radius, 1.5 * c.model_point.radius, 1e-9);
    EXPECT_EQ(c.data, -1);
  }
}

TEST(FollowedPoints, PointsWithAPairOfTheirOwnHaveNone) {
  const CorrespondenceSet pairs = followed(laid_on_itself(), {pair_of(2), pair_of(0)});
  EXPECT_EQ(pairs.size(), described_hand().points.size() - 2);
  for (const Correspondence& c : pairs) EXPECT_TRUE(c.model != 0 && c.model != 2);
}

TEST(FollowedPoints, AreBelievedMoreNearATrustedPairAndLessOffTheSkin) {
  const double alone = followed(laid_on_itself())[1].confidence;
  const CorrespondenceSet near = followed(laid_on_itself(), {pair_of(0)});
  EXPECT_EQ(near.front().model, 1);
  EXPECT_GT(near.front().confidence, alone);
  const homolog::Similarity off{1, Mat3::Identity(), Vec3(0.2 * described_hand().diagonal, 0, 0)};
  EXPECT_LT(followed(laid_on_itself(off))[1].confidence, alone);
}

TEST(FollowedPoints, AreMeasuredLikeThePointsThatTheDataHas) {
  CorrespondenceSet pairs = followed(laid_on_itself(), {pair_of(0)});
  pairs.push_back(pair_of(0));
  describe_followed(pairs, described_hand(), described_hand(), coarse());
  for (const Correspondence& c : pairs) {
    const SalientPoint& own = described_hand().points[c.model];
    EXPECT_NEAR(c.data_point.response, own.response, 0.05);
    EXPECT_EQ(c.data_point.direction_length > 0, own.direction_length > 0);
    if (own.direction_length > 0) EXPECT_GT(c.data_point.direction.dot(own.direction), 0.999);
    EXPECT_LT(c.descriptor_distance, 0.2 * descriptor_spread);  // the shape's own were sampled before it was turned
  }
}

}  // namespace
}  // namespace homolog
