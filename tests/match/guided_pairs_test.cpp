// SPDX-License-Identifier: MIT
#include "homolog/match/guided_pairs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fixtures/shapes.h"
#include "match/synthetic_pairs.h"

namespace homolog {
namespace {

SalientPoint at(const Vec3& position, double radius) { return {position, radius, Vec3::UnitZ(), 0, 1}; }

// Every node where it is.
Cloth flat(const Shape& model) {
  Cloth cloth;
  cloth.nodes = model.body.nodes;
  cloth.rotations.assign(cloth.nodes.size(), Mat3::Identity());
  cloth.scales.assign(cloth.nodes.size(), 1);
  return cloth;
}

CorrespondenceSet guided(const std::vector<SalientPoint>& model, const std::vector<SalientPoint>& data, const PairLimits& limits = {}) {
  const Shape shape = fixtures::bare_shape(model);
  return guided_pairs(flat(shape), shape, fixtures::bare_shape(data), DescriptorKind::free, limits);
}

TEST(GuidedPairs, PlaceIsLimitedInRadiiOfTheDataPoint) {
  for (const double radius : {0.01, 1.0, 50.0}) {
    const auto pairs_at = [&](double r, const PairLimits& limits) {
      return guided({at({0, 0, 0}, radius)}, {at({r * radius, 0, 0}, radius)}, limits).size();
    };
    EXPECT_EQ(pairs_at(0.59, {}), 1u);
    EXPECT_EQ(pairs_at(0.61, {}), 0u);
    EXPECT_EQ(pairs_at(1.49, {1.5}), 1u);
    EXPECT_EQ(pairs_at(1.51, {1.5}), 0u);
  }
}

TEST(GuidedPairs, SmallPointsMayBeMissedByMoreRadii) {
  const PairLimits limits{0.6, 0.35, 0.1};
  const auto pairs_at = [&](double distance, double radius) {
    return guided({at({0, 0, 0}, radius)}, {at({distance, 0, 0}, radius)}, limits).size();
  };
  EXPECT_EQ(pairs_at(0.099, 0.01), 1u);
  EXPECT_EQ(pairs_at(0.101, 0.01), 0u);
  EXPECT_EQ(pairs_at(0.59, 1), 1u);
  EXPECT_EQ(pairs_at(0.61, 1), 0u);
}

TEST(GuidedPairs, RadiusIsLimitedByLogarithm) {
  const auto pairs_at = [](double log_ratio, const PairLimits& limits) {
    return guided({at({0, 0, 0}, 1)}, {at({0, 0, 0}, std::exp(log_ratio))}, limits).size();
  };
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_EQ(pairs_at(sign * 0.34, {}), 1u);
    EXPECT_EQ(pairs_at(sign * 0.36, {}), 0u);
    EXPECT_EQ(pairs_at(sign * 0.69, {0.6, 0.7}), 1u);
    EXPECT_EQ(pairs_at(sign * 0.71, {0.6, 0.7}), 0u);
  }
}

TEST(GuidedPairs, RadiiAreComparedAtTheClothsScale) {
  const Shape model = fixtures::bare_shape({at({0, 0, 0}, 1)}), data = fixtures::bare_shape({at({0, 0, 0}, 5)});
  Cloth cloth = flat(model);
  EXPECT_TRUE(guided_pairs(cloth, model, data, DescriptorKind::free, {}).empty());
  cloth.scales[0] = 5;
  EXPECT_EQ(guided_pairs(cloth, model, data, DescriptorKind::free, {}).size(), 1u);
}

TEST(GuidedPairs, TheBetterOfTwoWinsAndBothStayOneToOne) {
  const auto pairs = guided({at({0, 0, 0}, 1), at({0.3, 0, 0}, 1)}, {at({0.25, 0, 0}, 1), at({0.5, 0, 0}, 1)});
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(std::pair(pairs[0].model, pairs[0].data), std::pair(0, 1));  // .5 away is still allowed; (1, 0) fits best and comes first
  EXPECT_EQ(std::pair(pairs[1].model, pairs[1].data), std::pair(1, 0));
  EXPECT_GT(pairs[1].confidence, pairs[0].confidence);
}

TEST(GuidedPairs, AMapOntoItselfPairsEveryPointWithItself) {
  std::mt19937 random(3);
  std::vector<SalientPoint> points;
  for (int i = 0; i < 60; ++i) points.push_back(synthetic::salient_point(random));
  const auto pairs = guided(points, points);
  ASSERT_EQ(pairs.size(), points.size());
  for (int i = 0; i < 60; ++i) {
    EXPECT_EQ(pairs[i].model, i);  // ordered by model index
    EXPECT_EQ(pairs[i].data, i);
    EXPECT_EQ(pairs[i].confidence, 1);
  }
}

}  // namespace
}  // namespace homolog
