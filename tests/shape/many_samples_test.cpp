// SPDX-License-Identifier: MIT
// Many trilinear values at once, against one after the other.
#include "homolog/shape/many_samples.h"

#include <gtest/gtest.h>

#include <random>

namespace homolog {
namespace {

TEST(ManySamples, AreThoseOfSample) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const std::array<int, 3>& size : {std::array{9, 12, 7}, std::array{1, 5, 2}}) {
    Volume<float> volume{{size, {0.3, -2, 1}, 0.25, Mat3::Identity()}, {}};
    for (std::size_t i = 0; i < volume.frame.voxels(); ++i) volume.values.push_back(static_cast<float>(uniform(random)));
    std::vector<Vec3> ways{{0, 0, 0}, {1, 0, 0}, {0, -1, 0}};
    while (ways.size() < 77) ways.push_back(Vec3(uniform(random), uniform(random), uniform(random)) * 2 - Vec3::Ones());
    const VectorColumns columns(ways);
    std::vector<float> sums(columns.x.size(), 1.0f);
    for (const double radius : {0.0, 1.0, 3.0, 40.0, 1e12}) {  // within, across the border, far beyond
      for (const Vec3& middle : {Vec3(4, 5, 3), Vec3(-0.5, 0, 2.5), Vec3(8, 11.5, 6.25)}) {
        std::fill(sums.begin(), sums.end(), 1.0f);
        add_samples(volume, middle, radius, columns, sums.data());
        for (std::size_t i = 0; i < ways.size(); ++i) {
          EXPECT_NEAR(sums[i] - 1, sample(volume, volume.frame.world_from_voxel(middle + radius * ways[i])), 1e-6) << radius;
        }
      }
    }
  }
}

}  // namespace
}  // namespace homolog
