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
  const ThinPlateSpline home = way_back(cloth, hand, hand);
  double sum = 0;
  for (std::size_t i = 0; i < hand.points.size(); ++i) {
    sum += (home(cloth.nodes[hand.body.point_node(static_cast<int>(i))]) - hand.points[i].position).norm();
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

TEST(RateByWayBack, WhatComesHomeIsBelievedMoreAndWhatDoesNotLess) {
  CorrespondenceSet pairs = two_pairs(0.2, 1, 0.75);
  rate_by_way_back(pairs, ThinPlateSpline{}, 1);
  EXPECT_GT(pairs[0].confidence, 0.75);
  EXPECT_LT(pairs[1].confidence, 0.75);
}

TEST(RateByWayBack, KnowsNoUnit) {
  CorrespondenceSet small = two_pairs(0.1, 1e-3, 0.6), large = two_pairs(0.1, 1e3, 0.6);
  rate_by_way_back(small, ThinPlateSpline{}, 1e-3);
  rate_by_way_back(large, ThinPlateSpline{}, 1e3);
  EXPECT_NEAR(small[1].confidence, large[1].confidence, 1e-12);
}

TEST(RateByWayBack, StaysBetweenZeroAndOne) {
  for (const double confidence : {0.0, 1.0}) {
    CorrespondenceSet pairs = two_pairs(1e9, 1, confidence);
    rate_by_way_back(pairs, ThinPlateSpline{}, 1);
    for (const Correspondence& c : pairs) EXPECT_NEAR(c.confidence, confidence, 1e-3);
  }
}

}  // namespace
}  // namespace homolog
