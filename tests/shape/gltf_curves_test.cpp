// SPDX-License-Identifier: MIT
#include "homolog/shape/gltf_curves.h"

#include <gmock/gmock.h>

namespace homolog {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

TEST(ValuesAt, GoesStraightBetweenTimesAndStandsBeyond) {
  const GltfCurve curve{GltfCurve::Between::straight, false, 2, {1, 3}, {0, 10, 4, 20}};
  EXPECT_THAT(values_at(curve, 0), ElementsAre(0, 10));
  EXPECT_THAT(values_at(curve, 1.5), ElementsAre(1, 12.5));
  EXPECT_THAT(values_at(curve, 9), ElementsAre(4, 20));
}

TEST(ValuesAt, Steps) {
  const GltfCurve curve{GltfCurve::Between::step, false, 1, {0, 1}, {5, 6}};
  EXPECT_THAT(values_at(curve, 0.99), ElementsAre(5));
  EXPECT_THAT(values_at(curve, 1), ElementsAre(6));
}

TEST(ValuesAt, FollowsACubic) {
  const auto x = [](double t) { return t * t * t - 2 * t; };
  const auto slope = [](double t) { return 3 * t * t - 2; };
  const GltfCurve curve{GltfCurve::Between::cubic, false, 1, {1, 3}, {0, x(1), slope(1), slope(3), x(3), 0}};
  for (const double t : {1.0, 1.4, 2.0, 2.9, 3.0}) EXPECT_NEAR(values_at(curve, t)[0], x(t), 1e-12);
}

TEST(ValuesAt, TurnsAlongTheShorterArc) {
  const double half = std::sin(M_PI / 8), whole = std::sin(M_PI / 4);
  const GltfCurve curve{GltfCurve::Between::straight, true, 4, {0, 1}, {0, 0, 0, 1, 0, 0, -whole, -std::cos(M_PI / 4)}};
  EXPECT_NEAR(std::abs(values_at(curve, 0.5)[2]), half, 1e-12);
}

TEST(TimesOf, AreThoseOfAllCurves) {
  const GltfChannel straight{0, GltfPath::scale, {GltfCurve::Between::straight, false, 1, {0, 2}, {0, 0}}};
  const GltfChannel step{0, GltfPath::scale, {GltfCurve::Between::step, false, 1, {0, 1, 2}, {0, 0, 0}}};
  EXPECT_THAT(times_of({straight, step}, 100), ElementsAre(0, DoubleEq(0.999), 1, DoubleEq(1.999), 2));
}

TEST(TimesOf, AreDenserWhereACurveIsCubic) {
  GltfChannel cubic{0, GltfPath::scale, {GltfCurve::Between::cubic, false, 1, {0, 1}, std::vector<double>(6, 0)}};
  const std::vector<double> times = times_of({cubic}, 1000);
  EXPECT_EQ(times.size(), 31u);
  EXPECT_NEAR(times[1], 1.0 / 30, 1e-12);
  cubic.curve.times[1] = 1e300;
  EXPECT_LT(times_of({cubic}, 1000).size(), 1010u) << "it ends";
}

}  // namespace
}  // namespace homolog
