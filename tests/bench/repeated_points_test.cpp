// SPDX-License-Identifier: MIT
#include "repeated_points.h"

#include <gtest/gtest.h>

#include "fixtures/solids.h"

namespace homolog::bench {
namespace {

SalientPoint point(double x, double radius) {
  SalientPoint p;
  p.position = Vec3(x, 0, 0);
  p.radius = radius;
  return p;
}

TEST(RepeatedPoints, CountsThoseNearInPlaceAndRadius) {
  const std::vector<SalientPoint> reference{point(0, 1), point(5, 1), point(10, 1), point(15, 1)};
  const std::vector<SalientPoint> points{point(0.2, 1.1), point(5.3, 1), point(10, 1.2), point(40, 1)};
  EXPECT_DOUBLE_EQ(repeated_share(reference, points), 0.25);
  EXPECT_DOUBLE_EQ(repeated_share(reference, points, {0.35, 0.15}), 0.5);
  EXPECT_DOUBLE_EQ(repeated_share(reference, reference), 1);
  EXPECT_DOUBLE_EQ(repeated_share({}, points), 0);
}

TEST(RepeatedPoints, ChanceIsTheShareOfTheRoomThatCounts) {  // one point of radius 1, looked for by one in a box of 4 x 4 x 4
  const Interior box = fixtures::rasterize(fixtures::box(Vec3::Zero(), Vec3::Constant(2)), 64);
  const double expected = 4 * M_PI / 3 * std::pow(0.25, 3) / 64;
  EXPECT_NEAR(chance_share({point(0, 1)}, {point(0, 1)}, box, 50000), expected, 0.3 * expected);
  EXPECT_EQ(chance_share({point(0, 1)}, {point(0, 2)}, box), 0);
}

}  // namespace
}  // namespace homolog::bench
