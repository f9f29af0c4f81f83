// SPDX-License-Identifier: MIT
#include "homolog/describe/farthest_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace homolog {
namespace {

// Points on a small grid, so that equal distances abound, some of them twice.
std::vector<Eigen::Vector3f> crowd(int count) {
  std::mt19937 generator(3);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < count; ++i) {
    const auto x = static_cast<float>(generator() % 40), y = static_cast<float>(generator() % 30), z = static_cast<float>(generator() % 7);
    points.emplace_back(x, y, z);
  }
  return points;
}

TEST(FarthestPoints, OrderIsThatOfThePlainLoop) {
  for (const int count : {1, 2, 24, 25, 700}) {
    const auto points = crowd(count);
    std::vector<float> distance(points.size(), std::numeric_limits<float>::infinity());
    FarthestPoints order(points);
    for (int step = 0; step < count; ++step) {
      const auto farthest = static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
      ASSERT_EQ(order.farthest().number, farthest) << step;
      ASSERT_EQ(order.farthest().squared_distance, distance[farthest]);
      order.choose(farthest);
      for (std::size_t i = 0; i < points.size(); ++i) distance[i] = std::min(distance[i], (points[i] - points[farthest]).squaredNorm());
    }
    EXPECT_EQ(order.farthest().squared_distance, 0);
  }
}

}  // namespace
}  // namespace homolog
