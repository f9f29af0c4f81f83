// SPDX-License-Identifier: MIT
// The data laid back: the inverse of a right map, wherever that begins, and so a witness against wrong pairs.
#include "homolog/match/way_back.h"

#include <gtest/gtest.h>

#include "fixtures/shapes.h"

namespace homolog {
namespace {

using namespace fixtures;

Cloth laid(const homolog::Similarity& map) {
  ThinPlateSpline spline;
  spline.similarity = map;
  spline.affine << map.scale * map.rotation, map.shift;
  return lay_cloth(described_hand().body, spline, Chirality::proper);
}

// Mean distance of the hand's salient points from themselves, there by the cloth's map and home by the other, in diagonals.
double missed_home(const Cloth& cloth) {
  const Shape& hand = described_hand();
  const Cloth back = laid_back(cloth, hand, hand);
  const NearestPoints near(hand.body.nodes);
  double sum = 0;
  for (std::size_t i = 0; i < hand.points.size(); ++i) {
    sum += (place_in(back, hand.body, near, cloth.nodes[hand.body.point_node(i)]) - hand.points[i].position).norm();
  }
  return sum / static_cast<double>(hand.points.size()) / hand.diagonal;
}

TEST(WayBack, ARightMapComesHome) { EXPECT_LT(missed_home(laid({})), 0.01); }

TEST(WayBack, WhatIsOffTheSurfaceDoesNot) {
  const Mat3 turn = Eigen::AngleAxisd(0.2, Vec3(1, 1, 1).normalized()).toRotationMatrix();
  EXPECT_GT(missed_home(laid({1.1, turn, Vec3(0.05, 0, 0)})), 2 * missed_home(laid({})));
}

// A pair of equal points, and one whose data point lies elsewhere by this share of the extent.
CorrespondenceSet two_pairs(double elsewhere, double extent, double confidence) {
  SalientPoint here, there;
  there.position = Vec3(elsewhere * extent, 0, 0);
  return {{0, 0, here, here, 0, confidence}, {1, 1, here, there, 0, confidence}};
}

TEST(WayBack, PlacesMoveWithTheNearestNodes) {
  const Shape& hand = described_hand();
  const homolog::Similarity map{1.3, random_rotation(3), Vec3(1, 2, 3)};
  const Cloth cloth = laid(map);
  const NearestPoints near(hand.body.nodes);
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(0.2, 0.1, -0.1), Vec3(hand.body.nodes[5])}) {
    EXPECT_LT((place_in(cloth, hand.body, near, x) - map(x)).norm(), 1e-6);
  }
}

// A body of the single node at the origin, which lies at home.
const Body& origin() {
  static const Body body = [] {
    Body one;
    one.nodes.assign(1, Vec3::Zero());
    one.neighbours.resize(1);
    return one;
  }();
  return body;
}

Cloth at_home() {
  Cloth cloth;
  cloth.nodes.assign(1, Vec3::Zero());
  cloth.frames.assign(1, Mat3::Identity());
  return cloth;
}

TEST(RateByWayBack, WhatComesHomeIsBelievedMoreAndWhatDoesNotLess) {
  CorrespondenceSet pairs = two_pairs(0.2, 1, 0.75);
  rate_by_way_back(pairs, at_home(), origin(), 1);
  EXPECT_GT(pairs[0].confidence, 0.75);
  EXPECT_LT(pairs[1].confidence, 0.75);
}

TEST(RateByWayBack, KnowsNoUnit) {
  CorrespondenceSet small = two_pairs(0.1, 1e-3, 0.6), large = two_pairs(0.1, 1e3, 0.6);
  rate_by_way_back(small, at_home(), origin(), 1e-3);
  rate_by_way_back(large, at_home(), origin(), 1e3);
  EXPECT_NEAR(small[1].confidence, large[1].confidence, 1e-12);
}

TEST(RateByWayBack, StaysBetweenZeroAndOne) {
  for (const double confidence : {0.0, 1.0}) {
    CorrespondenceSet pairs = two_pairs(1e9, 1, confidence);
    rate_by_way_back(pairs, at_home(), origin(), 1);
    for (const Correspondence& c : pairs) EXPECT_NEAR(c.confidence, confidence, 1e-3);
  }
}

}  // namespace
}  // namespace homolog
