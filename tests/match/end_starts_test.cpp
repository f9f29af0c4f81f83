// SPDX-License-Identifier: MIT
#include "homolog/match/end_starts.h"

#include <gtest/gtest.h>

#include "fixtures/shapes.h"

namespace homolog {
namespace {

using namespace fixtures;
using Move = fixtures::Similarity;

double mean_error(const GrownSet& start, const Move& truth) {
  double sum = 0;
  for (const Vec3& node : described_hand().body.nodes) sum += (start.spline(node) - truth(node)).norm();
  return sum / static_cast<double>(described_hand().body.nodes.size()) / (truth.scale * described_hand().diagonal);
}

TEST(EndStarts, TheBestOneLaysAShapeOnItsCopy) {
  for (const Mat3& rotation : {random_rotation(8), Mat3(random_rotation(9) * mirror_x())}) {
    const Move move{rotation, 20, {50, -30, 7}};
    const Shape data = described(moved(hand(), move));
    const Chirality chirality = rotation.determinant() > 0 ? Chirality::proper : Chirality::mirrored;
    const std::vector<GrownSet> starts = end_starts(follow_ends(described_hand(), data), described_hand(), data, chirality, 12);
    ASSERT_FALSE(starts.empty());
    EXPECT_LE(starts.size(), 12u);
    EXPECT_LT(mean_error(starts[0], move), 0.03);  // ways through a graph are as exact as its spacing, .04
    for (const GrownSet& start : starts) {
      EXPECT_EQ(start.chirality, chirality);
      EXPECT_TRUE(start.pairs.empty());
    }
  }
}

// What a stiff body cannot follow: a finger half as long again.
TEST(EndStarts, FollowALongerFinger) {
  const Shape data = described(join({hand(), capsule({0.11, 1.02, 0.06}, {0.13, 1.4, 0.1}, 0.09)}));
  const std::vector<GrownSet> starts = end_starts(follow_ends(described_hand(), data), described_hand(), data, Chirality::proper, 12);
  ASSERT_FALSE(starts.empty());
  EXPECT_LT((starts[0].spline(Vec3(0.11, 1.11, 0.06)) - Vec3(0.13, 1.49, 0.1)).norm(), 0.2);  // it is .38 away in place
  EXPECT_LT(mean_error(starts[0], {}), 0.06);
}

TEST(EndStarts, WithoutEndsThereIsNone) {
  const Shape empty = bare_shape({});
  EXPECT_TRUE(follow_ends(empty, empty).empty());
}

}  // namespace
}  // namespace homolog
