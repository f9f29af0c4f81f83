// SPDX-License-Identifier: MIT
// Pairs that the map misses, or that have many more similar rivals, are less likely right and are left out; followed points join them.
#include "homolog/match/trusted_pairs.h"

#include <gtest/gtest.h>

#include "fixtures/shapes.h"

namespace homolog {
namespace {

using namespace fixtures;

constexpr int count = 8;
constexpr double good_merit = 0.6;

// Points along a line, told apart by their descriptors.
Shape line() {
  std::vector<SalientPoint> points(count);
  std::vector<float> descriptors;
  for (int i = 0; i < count; ++i) {
    points[i].position = Vec3(0.1 * i, 0, 0);
    points[i].radius = 0.05;
    descriptors.push_back(static_cast<float>(i));
  }
  return bare_shape(points, descriptors);
}

CorrespondenceSet identity_pairs(const Shape& shape) {
  CorrespondenceSet pairs;
  for (int i = 0; i < count; ++i) pairs.push_back({i, i, shape.points[i], shape.points[i], 0, 0});
  return pairs;
}

CorrespondenceSet trusted(CorrespondenceSet pairs, const Shape& shape, double merit, const std::vector<double>& misses) {
  Cloth cloth;
  for (int i = 0; i < count; ++i) cloth.nodes.emplace_back(shape.points[i].position + Vec3(0, misses[i], 0));
  rate_pairs(pairs, cloth, merit, 1, shape, shape, DescriptorKind::free);
  return trusted_pairs(std::move(pairs));
}

TEST(TrustedPairs, WhatTheMapMeetsStays) {
  const CorrespondenceSet pairs = trusted(identity_pairs(line()), line(), good_merit, std::vector<double>(count, 0));
  ASSERT_EQ(pairs.size(), static_cast<std::size_t>(count));
  for (const Correspondence& c : pairs) EXPECT_GT(c.confidence, 0.8);
}

TEST(TrustedPairs, WhatTheMapMissesLeaves) {
  std::vector<double> misses(count, 0);
  misses[2] = 0.1;
  const CorrespondenceSet pairs = trusted(identity_pairs(line()), line(), good_merit, misses);
  ASSERT_EQ(pairs.size(), static_cast<std::size_t>(count - 1));
  for (const Correspondence& c : pairs) EXPECT_NE(c.model, 2);
}

TEST(TrustedPairs, RivalsLowerTheConfidence) {
  CorrespondenceSet pairs = identity_pairs(line());
  pairs[3].data = 6;
  pairs[3].data_point = pairs[3].model_point;  // no miss: the descriptors alone disagree
  pairs[3].descriptor_distance = 3;
  const CorrespondenceSet kept = trusted(pairs, line(), 2, std::vector<double>(count, 0));
  ASSERT_EQ(kept.size(), static_cast<std::size_t>(count));
  EXPECT_LT(kept[3].confidence, kept[2].confidence);
}

TEST(TrustedPairs, NoneStaysInADoubtfulMatch) {
  EXPECT_TRUE(trusted(identity_pairs(line()), line(), -0.5, std::vector<double>(count, 0.005)).empty());
}

CorrespondenceSet sure_pairs(const Shape& shape) {
  CorrespondenceSet pairs = identity_pairs(shape);
  for (Correspondence& c : pairs) c.confidence = 0.95;
  return pairs;
}

// A followed pair of model point i, far from all others.
Correspondence followed(int i, double confidence) {
  Correspondence pair{i, -1, {}, {}, 0, confidence};
  pair.data_point.position = Vec3(0, 10.0 + i, 0);
  pair.data_point.radius = 0.05;
  return pair;
}

TEST(ToldPairs, FollowedPointsThatDeserveTrustJoin) {
  CorrespondenceSet many;
  for (int i = 10; i < 30; ++i) many.push_back(followed(i, i < 22 ? 0.85 : 0.8));
  const CorrespondenceSet told = told_pairs(sure_pairs(line()), many);
  EXPECT_EQ(told.size(), count + 12u);
  for (std::size_t i = 1; i < told.size(); ++i) EXPECT_LT(told[i - 1].model, told[i].model);
}

TEST(ToldPairs, TheBestFollowedOnesFillUpToSeven) {
  CorrespondenceSet three = sure_pairs(line()), doubtful;
  three.resize(3);
  for (int i = 10; i < 30; ++i) doubtful.push_back(followed(i, 0.01 * i));
  const CorrespondenceSet told = told_pairs(three, doubtful);
  ASSERT_EQ(told.size(), 7u);
  for (std::size_t i = 3; i < 7; ++i) EXPECT_EQ(told[i].model, 23 + static_cast<int>(i));
}

TEST(ToldPairs, NoPlaceIsToldTwice) {
  const Shape shape = line();
  Correspondence same = followed(10, 0.9);
  same.data_point.position = shape.points[3].position + Vec3(0, 0.02, 0);
  EXPECT_EQ(told_pairs(sure_pairs(shape), {same}).size(), static_cast<std::size_t>(count));
}

}  // namespace
}  // namespace homolog
