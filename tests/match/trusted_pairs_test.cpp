// SPDX-License-Identifier: MIT
// Pairs that the map misses, or that have many more similar rivals, are less likely right and are left out; five always stay.
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
  return trusted_pairs(std::move(pairs), cloth, merit, 1, shape, shape, DescriptorKind::free);
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

TEST(TrustedPairs, FiveStayEvenInADoubtfulMatch) {
  std::vector<double> misses;
  for (int i = 0; i < count; ++i) misses.push_back(0.005 * i);
  const CorrespondenceSet pairs = trusted(identity_pairs(line()), line(), -0.5, misses);
  ASSERT_EQ(pairs.size(), 5u);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(pairs[i].model, i);
  for (const Correspondence& c : pairs) EXPECT_LT(c.confidence, 0.6);
}

}  // namespace
}  // namespace homolog
