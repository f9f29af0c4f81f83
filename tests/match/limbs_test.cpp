// SPDX-License-Identifier: MIT
// Places on limbs are told by ends that belong together, and a cloth drawn along them follows a longer finger to its tip.
#include "homolog/match/limbs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fixtures/laid.h"
#include "homolog/match/draw_onto.h"

namespace homolog {
namespace {

using namespace fixtures;

std::vector<SurfaceSample> skin_of(const Shape& shape) {
  return {shape.surface.begin(), shape.surface.begin() + static_cast<std::ptrdiff_t>(shape.body.surface_count)};
}

TEST(Limbs, EveryEndOfAShapeOnItselfBelongsToItself) {
  const Shape& hand = described_hand();
  const EndsTogether ends = ends_together(laid(hand, {0.01, 0, 0}), hand, hand);
  EXPECT_GE(ends.model.size(), 5u);
  EXPECT_EQ(ends.model.size(), hand.ends.nodes.size());
  EXPECT_EQ(ends.model, ends.data);
}

TEST(Limbs, EndsTooFarApartOrTooFewDoNotBelongTogether) {
  const Shape& hand = described_hand();
  EXPECT_TRUE(ends_together(laid(hand, {2 * hand.diagonal, 0, 0}), hand, hand).model.empty());
  const Shape bar = described(capsule({0, 0, 0}, {2, 0, 0}, 0.2));  // it has two ends
  EXPECT_TRUE(ends_together(laid(bar, Vec3::Zero()), bar, bar).model.empty());
}

// The tip is a whole limb out, and the way in to the trunk falls evenly.
TEST(Limbs, PlacesAreToldByTheWayToTheTip) {
  const Shape& hand = described_hand();
  const std::vector<int> chosen = {0, 1, 2};
  const std::vector<LimbPlace> places = limb_places(skin_of(hand), hand, chosen);
  ASSERT_EQ(places.size(), hand.body.surface_count);
  const float tip = places[hand.ends.nodes[0]].out;
  EXPECT_GT(tip, 1);
  for (int k : chosen) {
    const LimbPlace& at_tip = places[hand.ends.nodes[k]];
    EXPECT_EQ(at_tip.limb, static_cast<float>(k));
    EXPECT_NEAR(at_tip.out, tip, 1e-5);
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_LE(places[i].out, tip * (1 + 1e-6f));
    if (places[i].out == 0) continue;
    const auto own = hand.ends.ways(static_cast<Eigen::Index>(i), static_cast<int>(places[i].limb));
    EXPECT_LT(own, hand.diagonal);
  }
  EXPECT_GT(std::count_if(places.begin(), places.end(), [](const LimbPlace& p) { return p.out == 0; }), 0);
}

TEST(Limbs, AClothDrawnAlongThemReachesTheTipOfALongerLimb) {
  const Shape model = star({1, 0, 0}), data = star({1.6, 0, 0});
  const ClothSchedule first{10, 0.08, 0.02, 0.7, 0.2}, last{14, 0.03, 0.008, 0.7, 0.1};
  Cloth plain = laid(model, Vec3::Zero()), along = plain;
  const EndsTogether ends = ends_together(along, model, data);
  ASSERT_EQ(ends.model.size(), 4u);
  draw_onto(plain, model, data, {}, first, 400);
  draw_onto(along, model, data, {}, first, 400, ends);
  for (Cloth* cloth : {&plain, &along}) draw_onto(*cloth, model, data, {}, last, 1200);
  const auto missed = [&](const Cloth& cloth) {
    double least = model.diagonal;
    for (const int end : model.ends.nodes) least = std::min(least, (cloth.nodes[end] - Vec3(1.72, 0, 0)).norm());
    return least;
  };
  EXPECT_LT(missed(along), 0.05 * model.diagonal);
  EXPECT_LT(missed(along), 0.6 * missed(plain));
}

}  // namespace
}  // namespace homolog
