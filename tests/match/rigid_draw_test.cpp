// SPDX-License-Identifier: MIT
// Nearest similarity and tangent planes: a stretched start comes home, a cut face draws nothing on, a mirror image stays one.
#include "homolog/match/rigid_draw.h"

#include <gtest/gtest.h>

#include "fixtures/laid.h"
#include "fixtures/shapes.h"

namespace homolog {
namespace {

using namespace fixtures;

// The model laid by a map, its nodes drawn out along x by this share.
Cloth stretched(const Shape& model, const homolog::Similarity& map, double share, Chirality chirality = Chirality::proper) {
  std::vector<Vec3> places;
  for (const Vec3& node : model.body.nodes) places.push_back(map(node + Vec3(share * node.x(), 0, 0)));
  return lay_cloth(model.body, std::move(places), map, chirality);
}

// Root mean square distance of the nodes from where they were, in diagonals.
double missed(const Cloth& cloth, const Shape& shape) {
  double sum = 0;
  for (std::size_t i = 0; i < cloth.nodes.size(); ++i) sum += (cloth.nodes[i] - shape.body.nodes[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(cloth.nodes.size())) / shape.diagonal;
}

TEST(RigidDraw, AStretchedStartComesHome) {
  const Shape& hand = described_hand();
  const Mat3 turn = Eigen::AngleAxisd(0.1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const Cloth start = stretched(hand, {1.06, turn, 0.02 * hand.diagonal * Vec3(1, -1, 0)}, 0.08);
  EXPECT_GT(missed(start, hand), 0.03);
  const Cloth drawn = rigidly_drawn(start, hand, hand);
  EXPECT_LT(missed(drawn, hand), 1e-4);
  EXPECT_NEAR(drawn.scale, 1, 1e-4);
}

TEST(RigidDraw, IsOneSimilarity) {
  const Shape& hand = described_hand();
  const Cloth drawn = rigidly_drawn(stretched(hand, {1.05, Mat3::Identity(), Vec3::Zero()}, 0.2), hand, hand);
  const homolog::Similarity similarity = similarity_of(drawn, hand.body);
  for (std::size_t i = 0; i < drawn.nodes.size(); ++i) {
    EXPECT_LT((drawn.nodes[i] - similarity(hand.body.nodes[i])).norm(), 1e-9 * hand.diagonal);
  }
}

TEST(RigidDraw, WhatTheDataLacksDrawsNothingOn) {  // samples in a plane beside the hand, as a cut leaves them
  Shape cut = described_hand();
  for (int i = 0; i < 200; ++i) {
    const Vec3 place(0.3 * (i % 20 - 10), 0.3 * (i / 20 - 5), 3);
    cut.surface.push_back({place / 10 * cut.diagonal, Vec3::UnitZ()});
  }
  const Cloth start = stretched(described_hand(), {1.03, Mat3::Identity(), Vec3::Zero()}, 0.05);
  EXPECT_LT(missed(rigidly_drawn(start, cut, described_hand()), described_hand()), 1e-4);
}

TEST(RigidDraw, AMirrorImageStaysOne) {
  const Shape& hand = described_hand();
  Mat3 mirror = Mat3::Identity();
  mirror(2, 2) = -1;
  const Cloth drawn = rigidly_drawn(stretched(hand, {1, mirror, Vec3::Zero()}, 0.05, Chirality::mirrored), hand, hand);
  EXPECT_EQ(drawn.chirality, Chirality::mirrored);
  EXPECT_LT(similarity_of(drawn, hand.body).rotation.determinant(), 0);
}

TEST(RigidDraw, WithoutSamplesNothingMoves) {
  const homolog::Similarity start{2, Mat3::Identity(), {1, 2, 3}};
  EXPECT_EQ(settled_rigidly(start, described_hand().surface, {}).matrix(), start.matrix());
}

}  // namespace
}  // namespace homolog
