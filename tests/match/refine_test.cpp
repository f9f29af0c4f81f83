// SPDX-License-Identifier: MIT
#include "homolog/match/refine.h"

#include <gtest/gtest.h>

#include "fixtures/shapes.h"
#include "homolog/match/evidence.h"

namespace homolog {
namespace {

using namespace fixtures;

const Shape& shape() {
  static const Shape described_hand = described(hand());
  return described_hand;
}

GrownSet start(const homolog::Similarity& map) {
  GrownSet set;
  set.spline.similarity = map;
  set.spline.affine << map.scale * map.rotation, map.shift;
  return set;
}

TEST(Refine, AStartThatIsSlightlyOffEndsWithEveryPointAtItself) {
  const Mat3 turn = Eigen::AngleAxisd(0.15, Vec3(1, 1, 1).normalized()).toRotationMatrix();
  Refined refined = draw_set(start({1.05, turn, Vec3(0.02, 0, 0)}), shape(), shape(), DescriptorKind::free);
  guide_pairs(refined, shape(), shape(), DescriptorKind::free);
  ASSERT_EQ(refined.pairs.size(), shape().points.size());
  EXPECT_GT(refined.evidence.support, 0.8 * static_cast<double>(shape().points.size()));
  for (const Correspondence& c : refined.pairs) EXPECT_EQ(c.model, c.data);
  EXPECT_EQ(refined.confidence, confidence_of(refined.evidence, Chirality::proper));
}

TEST(Refine, TheMatchTellsItsClothAsASpline) {
  Refined refined = draw_set(start({}), shape(), shape(), DescriptorKind::free);
  guide_pairs(refined, shape(), shape(), DescriptorKind::free);
  const Match match = match_of(refined, shape());
  for (std::size_t i = 0; i < refined.cloth.nodes.size(); ++i) {
    const double missed = (match.data_from_model(shape().body.nodes[i]) - refined.cloth.nodes[i]).norm();
    EXPECT_LT(missed, 0.1 * shape().body.spacing);  // nuggets of .02 spacings smooth a little
  }
  EXPECT_EQ(match.handedness, Handedness::proper);
  EXPECT_EQ(match.model_coverage, refined.evidence.model_reached);
  EXPECT_NEAR(match.bending, 0, 1e-9);  // the pairs are the identity, whatever the cloth
  for (const Correspondence& c : match.pairs) EXPECT_GT(c.confidence, 0.9);
}

TEST(Refine, ExtentIsTheSmallerOfMappedModelAndData) {
  Cloth cloth;
  cloth.scale = 0.5;
  EXPECT_DOUBLE_EQ(extent_of(cloth, shape(), shape()), 0.5 * shape().diagonal);
  cloth.scale = 2;
  EXPECT_DOUBLE_EQ(extent_of(cloth, shape(), shape()), shape().diagonal);
}

}  // namespace
}  // namespace homolog
