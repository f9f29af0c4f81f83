// SPDX-License-Identifier: MIT
#include "homolog/shape/rig.h"

#include <gtest/gtest.h>

namespace homolog {
namespace {

TEST(StrongestInfluences, JoinsThoseOfOneJointAndKeepsFourOfSumOne) {
  const Influences four = strongest_influences({{7, 0.1f}, {2, 0.2f}, {7, 0.3f}, {1, 0.05f}, {3, 0.3f}, {4, 0.1f}, {5, -1}});
  EXPECT_EQ(four[0].joint, 7);
  EXPECT_FLOAT_EQ(four[0].weight, 0.4f);
  EXPECT_EQ(four[1].joint, 3);
  EXPECT_EQ(four[3].joint, 4);
  EXPECT_FLOAT_EQ(four[0].weight + four[1].weight + four[2].weight + four[3].weight, 1);
  EXPECT_EQ(four[4].weight, 0);
  EXPECT_EQ(most_influences({four}), 4u);
}

TEST(StrongestInfluences, KeepsUpToEightIfAskedFor) {
  std::vector<Influence> ten;
  for (std::uint16_t joint = 0; joint < 10; ++joint) ten.push_back({joint, 1.0f + joint});
  const Influences eight = strongest_influences(ten, 8);
  EXPECT_EQ(eight[7].joint, 2);
  EXPECT_FLOAT_EQ(eight[7].weight, 3 / 52.0f);
  EXPECT_EQ(most_influences({strongest_influences(ten), eight}), 8u);
}

TEST(StrongestInfluences, AreNoneWithoutAPositiveWeight) {
  for (const Influence& influence : strongest_influences({{3, 0}, {2, -1}})) EXPECT_EQ(influence.weight, 0);
}

TEST(PoseOf, FindsWhatAMatrixWasMadeOf) {
  const Pose pose{{1, -2, 3}, Eigen::Quaterniond(0.5, -0.5, 0.1, 0.7).normalized(), {-2, 0.5, 3}};
  const Pose again = pose_of(matrix_of(pose));
  EXPECT_TRUE(matrix_of(again).isApprox(matrix_of(pose), 1e-12));
  EXPECT_TRUE(again.scale.isApprox(pose.scale, 1e-12));
  EXPECT_LT(again.turn.angularDistance(pose.turn), 1e-7);
}

TEST(PoseOf, BearsWhatHasNoSize) {
  for (const Vec3& scale : {Vec3(0, 0, 0), Vec3(2, 0, 1)}) {
    const Pose pose = pose_of(matrix_of({{1, 2, 3}, Eigen::Quaterniond::Identity(), scale}));
    EXPECT_TRUE(pose.scale.isApprox(scale));
    EXPECT_NEAR(pose.turn.norm(), 1, 1e-9);
  }
}

}  // namespace
}  // namespace homolog
