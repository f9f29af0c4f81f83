// SPDX-License-Identifier: MIT
// Sec. 6.2.3: what eq. 8 and 9 let through, largest set first.
#include "homolog/match/verify.h"

#include <gtest/gtest.h>

#include "fixtures/shapes.h"

namespace homolog {
namespace {

using namespace fixtures;

// Every point with itself, seen through `map` in the data.
CorrespondenceSet all_points(std::size_t count = 1000) {
  CorrespondenceSet set;
  for (int i = 0; i < static_cast<int>(std::min(count, described_hand().points.size())); ++i) {
    SalientPoint point = described_hand().points[i];
    point.direction_length = 0;
    set.push_back({i, i, point, point, 0, 0});
  }
  return set;
}

TEST(Sec623, TheIdentityIsCorrectAndBendsNothing) {
  const std::vector<Match> matches = verified_sets({all_points()}, described_hand(), described_hand(), coarse(), false);
  ASSERT_EQ(matches.size(), 1u);
  EXPECT_NEAR(matches[0].bending, 0, 1e-6);
  EXPECT_LT(matches[0].chamfer, 0.001);
  EXPECT_EQ(matches[0].handedness, Handedness::proper);
  EXPECT_EQ(matches[0].confidence, 1);  // every model point is matched
  EXPECT_TRUE(verified_sets({all_points()}, described_hand(), described_hand(), coarse(), true).empty());
}

TEST(Sec623, TheLargestSetComesFirst) {
  const std::size_t count = described_hand().points.size();
  ASSERT_GE(count, 7u);
  const std::vector<Match> matches =
      verified_sets({all_points(count - 1), all_points()}, described_hand(), described_hand(), coarse(), false);
  ASSERT_EQ(matches.size(), 2u);
  EXPECT_EQ(matches[0].pairs.size(), count);
  Params params = coarse();
  params.match.matches = 1;
  EXPECT_EQ(verified_sets({all_points(count - 1), all_points()}, described_hand(), described_hand(), params, false).size(), 1u);
}

TEST(Verify, CoverageIsTheSkinNearTheMatchedPoints) {
  CorrespondenceSet set = all_points();
  for (Correspondence& c : set) c.model_point.radius = 0.03;  // so that the model is seen at its thin places only
  const std::vector<Match> matches = verified_sets({set}, described_hand(), described_hand(), coarse(), false);
  ASSERT_EQ(matches.size(), 1u);
  EXPECT_GT(matches[0].model_coverage, 0);
  EXPECT_LT(matches[0].model_coverage, 0.5);
  EXPECT_EQ(matches[0].data_coverage, 1);  // the hand has points everywhere
}

TEST(Sec623, AMapBesideTheDataIsRejectedByItsChamferDistance) {
  CorrespondenceSet aside = all_points();
  for (Correspondence& c : aside) c.data_point.position += Vec3(0.2 * described_hand().diagonal, 0, 0);
  EXPECT_TRUE(verified_sets({aside}, described_hand(), described_hand(), coarse(), false).empty());
}

TEST(Sec623, ABentMapIsRejectedByItsEnergy) {
  CorrespondenceSet bent = all_points();
  for (std::size_t i = 0; i < bent.size(); i += 2) bent[i].data_point.position.z() += 0.05;
  Params params = coarse();
  params.paper.bending_limit = 0.001;
  EXPECT_TRUE(verified_sets({bent}, described_hand(), described_hand(), params, false).empty());
}

TEST(Verify, MirrorIsToldAndObeyed) {
  CorrespondenceSet mirrored = all_points();
  for (Correspondence& c : mirrored) c.data_point.position.z() *= -1;  // the hand is nearly flat in z, so eq. 9 lets it through
  Params params = coarse();
  params.paper.chamfer_limit = 1;
  const std::vector<Match> matches = verified_sets({mirrored}, described_hand(), described_hand(), params, false);
  ASSERT_EQ(matches.size(), 1u);
  EXPECT_EQ(matches[0].handedness, Handedness::mirrored);
  EXPECT_NEAR(matches[0].similarity.rotation.determinant(), -1, 1e-9);
  params.match.mirror = Mirror::forbid;
  EXPECT_TRUE(verified_sets({mirrored}, described_hand(), described_hand(), params, false).empty());
  params.match.mirror = Mirror::only;
  EXPECT_EQ(verified_sets({mirrored, all_points()}, described_hand(), described_hand(), params, false).size(), 1u);
}

}  // namespace
}  // namespace homolog
