// SPDX-License-Identifier: MIT
#include "homolog/shape/inside_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace homolog {
namespace {

Interior random_voxels(const std::array<int, 3>& size, double share, std::uint32_t seed) {
  Interior interior{{size, Vec3(1, 2, 3), 0.25}, {}};
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < interior.frame.voxels(); ++i) interior.values.push_back(random() < share * 4294967296.0 ? 0.5f : 0.49f);
  return interior;
}

/// Squared distance in voxels to the nearest inside, by looking at all.
double squared_by_brute_force(const Interior& interior, int i, int j, int k) {
  double nearest = std::numeric_limits<double>::infinity();
  const auto& n = interior.frame.size;
  for (int c = 0; c < n[2]; ++c) {
    for (int b = 0; b < n[1]; ++b) {
      for (int a = 0; a < n[0]; ++a) {
        if (interior.at(a, b, c) >= 0.5f) nearest = std::min(nearest, std::pow(a - i, 2) + std::pow(b - j, 2) + std::pow(c - k, 2));
      }
    }
  }
  return nearest;
}

TEST(InsideTree, IsExact) {
  for (const double share : {0.3, 0.02, 0.001}) {
    for (const std::array<int, 3>& size : {std::array{9, 12, 15}, std::array{20, 3, 11}, std::array{1, 30, 1}}) {
      const Interior interior = random_voxels(size, share, 7);
      const InsideTree tree(interior);
      for (int k = 0; k < size[2]; ++k) {
        for (int j = 0; j < size[1]; ++j) {
          for (int i = 0; i < size[0]; ++i) {
            EXPECT_EQ(tree.distance(i, j, k), static_cast<float>(0.25 * std::sqrt(squared_by_brute_force(interior, i, j, k))));
          }
        }
      }
    }
  }
}

TEST(InsideTree, IsInfiniteWithoutInside) {
  const Interior interior = random_voxels({5, 6, 7}, 0, 1);
  EXPECT_EQ(InsideTree(interior).distance(1, 2, 3), std::numeric_limits<float>::infinity());
}

}  // namespace
}  // namespace homolog
