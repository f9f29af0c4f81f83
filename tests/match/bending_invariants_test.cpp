// SPDX-License-Identifier: MIT
// Bending and scaling leave ways inside, thickness and ends as they are; maps that tear, turn about or fall short do not.
#include "homolog/match/bending_invariants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fixtures/shapes.h"

namespace homolog {
namespace {

using namespace fixtures;

// The model's nodes laid by any map; the normals turn as told.
Cloth laid(const Shape& model, const std::function<Vec3(const Vec3&)>& place, const std::function<Mat3(const Vec3&)>& turn,
           double scale = 1) {
  Cloth cloth;
  cloth.scale = scale;
  for (const Vec3& node : model.body.nodes) {
    cloth.nodes.push_back(place(node));
    cloth.rotations.push_back(turn(node));
    cloth.scales.push_back(scale);
  }
  return cloth;
}

double ways_of(const Cloth& cloth, const Shape& model, const Shape& data, double extent) {
  return ways_changed(mapped_skin(cloth, model.body), cloth.scale, model, data, extent);
}

double thickness_of(const Cloth& cloth, const Shape& model, const Shape& data, double extent) {
  const std::vector<SurfaceSample> laid = mapped_skin(cloth, model.body);
  std::vector<NearestSample> nearest;
  for (const SurfaceSample& sample : laid) nearest.push_back(nearest_sample(data.surface_blocks, sample.position));
  return thickness_changed(laid, nearest, model, data, extent);
}

Mat3 no_turn(const Vec3&) { return Mat3::Identity(); }
Mat3 about_z(double angle) { return Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix(); }

// A club from x = 0 to 2, thin up to 1, thick beyond.
Solid club() { return join({capsule({0, 0, 0}, {1, 0, 0}, 0.1), capsule({1.2, 0, 0}, {2, 0, 0}, 0.2)}); }

// Half a ring of radius 1 about z, made of short capsules.
Solid half_ring() {
  std::vector<Solid> links;
  const auto at = [](int k) { return Vec3(std::cos(k * M_PI / 24), std::sin(k * M_PI / 24), 0); };
  for (int k = 0; k < 24; ++k) links.push_back(capsule(at(k), at(k + 1), 0.12));
  return join(links);
}

TEST(BendingInvariants, TheIdentityChangesNothing) {
  const Shape& hand = described_hand();
  const Cloth cloth = laid(
      hand, [](const Vec3& x) { return x; }, no_turn);
  EXPECT_NEAR(ways_of(cloth, hand, hand, hand.diagonal), 0, 1e-9);
  EXPECT_LT(thickness_of(cloth, hand, hand, hand.diagonal), 0.1);  // nearest samples are not always the same ones
  EXPECT_NEAR(ends_missed(cloth, hand, hand, hand.diagonal), 0, 1e-9);
}

TEST(BendingInvariants, AStraightBarMayBeBentAndScaled) {
  const Shape bar = described(capsule({0, 0, 0}, {M_PI / 2, 0, 0}, 0.06)), ring = described(half_ring());
  const auto angle = [](const Vec3& x) { return 2 * x.x(); };
  const auto place = [&](const Vec3& x) {
    return Vec3((1 + 2 * x.y()) * std::cos(angle(x)), (1 + 2 * x.y()) * std::sin(angle(x)), 2 * x.z());
  };
  // The bar's y goes outwards and its x along the ring.
  const auto turn = [&](const Vec3& x) { return Mat3(about_z(angle(x)) * (Mat3() << 0, 1, 0, 1, 0, 0, 0, 0, 1).finished()); };
  const Cloth cloth = laid(bar, place, turn, 2);
  EXPECT_LT(ways_of(cloth, bar, ring, ring.diagonal), 0.1);
  EXPECT_LT(thickness_of(cloth, bar, ring, ring.diagonal), 0.1);
  EXPECT_LT(ends_missed(cloth, bar, ring, ring.diagonal), 0.08);
}

TEST(BendingInvariants, WaysTellAMapThatJumpsAcrossAGap) {
  // Legs of a U, one laid upside down on itself: as near, as smooth, but torn off at the foot.
  const Shape u =
      described(join({capsule({0, 0, 0}, {0, 2, 0}, 0.1), capsule({0.6, 0, 0}, {0.6, 2, 0}, 0.1), capsule({0, 0, 0}, {0.6, 0, 0}, 0.1)}));
  const auto flipped = [](const Vec3& x) { return x.x() > 0.45; };
  const Cloth torn = laid(
      u, [&](const Vec3& x) { return flipped(x) ? Vec3(1.2 - x.x(), 2 - x.y(), x.z()) : x; },
      [&](const Vec3& x) { return flipped(x) ? about_z(M_PI) : Mat3(Mat3::Identity()); });
  EXPECT_GT(ways_of(torn, u, u, u.diagonal), 0.25);
}

TEST(BendingInvariants, ThicknessTellsTheEndsOfAClubApart) {
  const Shape shape = described(club());
  const Cloth reversed = laid(
      shape, [](const Vec3& x) { return Vec3(2 - x.x(), -x.y(), x.z()); }, [](const Vec3&) { return about_z(M_PI); });
  EXPECT_GT(thickness_of(reversed, shape, shape, 2 * shape.diagonal), 0.25);  // the third that is thin counts 1 beside the median
}

TEST(BendingInvariants, EndsTellAMapThatFallsShort) {
  const Shape bar = described(capsule({-1, 0, 0}, {1, 0, 0}, 0.2));
  const Cloth shrunk = laid(
      bar, [](const Vec3& x) { return Vec3(0.6 * x.x(), x.y(), x.z()); }, no_turn);
  EXPECT_GT(ends_missed(shrunk, bar, bar, bar.diagonal), 0.1);
}

TEST(BendingInvariants, WhereNothingIsMappedAllIsChanged) {
  const Shape& hand = described_hand();
  const Cloth away = laid(
      hand, [&](const Vec3& x) { return Vec3(x + Vec3(5 * hand.diagonal, 0, 0)); }, no_turn);
  EXPECT_EQ(ways_of(away, hand, hand, hand.diagonal), 1);
  EXPECT_EQ(thickness_of(away, hand, hand, hand.diagonal), 1);
  EXPECT_NEAR(ends_missed(away, hand, hand, hand.diagonal), 0.3, 1e-12);
}

}  // namespace
}  // namespace homolog
