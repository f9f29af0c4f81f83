// SPDX-License-Identifier: MIT
#include "homolog/shape/volume.h"

#include <gtest/gtest.h>

#include <limits>

namespace homolog {
namespace {

Volume<float> trilinear_field() {
  Volume<float> volume{{{4, 5, 6}, {10, 20, 30}, 0.5}, std::vector<float>(120)};
  for (int k = 0; k < 6; ++k) {
    for (int j = 0; j < 5; ++j) {
      for (int i = 0; i < 4; ++i) volume.at(i, j, k) = static_cast<float>(1 + i + 2 * j - k + i * j * k);
    }
  }
  return volume;
}

TEST(Sample, ReproducesATrilinearFunction) {
  const Volume<float> volume = trilinear_field();
  const Vec3 v(1.25, 2.5, 3.75);
  EXPECT_NEAR(sample(volume, volume.frame.world_from_voxel(v)), 1 + v.x() + 2 * v.y() - v.z() + v.x() * v.y() * v.z(), 1e-5);
  EXPECT_EQ(sample(volume, volume.frame.world_from_voxel({3, 4, 5})), volume.at(3, 4, 5));
  EXPECT_EQ(sample(volume, volume.frame.world_from_voxel({0, 0, 0})), volume.at(0, 0, 0));
}

TEST(Sample, FallsToZeroWithinAVoxelOutsideAndIsZeroBeyond) {
  const Volume<float> volume = trilinear_field();
  EXPECT_NEAR(sample(volume, volume.frame.world_from_voxel({3.5, 4, 5})), volume.at(3, 4, 5) / 2, 1e-4);
  EXPECT_NEAR(sample(volume, volume.frame.world_from_voxel({-0.25, 0, 0})), 0.75, 1e-6);
  EXPECT_EQ(sample(volume, volume.frame.world_from_voxel({-1, 2, 2})), 0);
  EXPECT_EQ(sample(volume, volume.frame.world_from_voxel({1, 2, 6})), 0);
  EXPECT_EQ(sample(volume, {1e300, 0, 0}), 0);
  EXPECT_EQ(sample(volume, {std::numeric_limits<double>::quiet_NaN(), 20, 30}), 0);
}

TEST(GridFrame, VoxelsAndWorldAreInverse) {
  const GridFrame frame{{4, 5, 6}, {10, 20, 30}, 0.5};
  EXPECT_EQ(frame.world_from_voxel({2, 0, 1}), Vec3(11, 20, 30.5));
  EXPECT_EQ(frame.voxel_from_world(frame.world_from_voxel({1, 2, 3})), Vec3(1, 2, 3));
  EXPECT_EQ(frame.index(3, 4, 5), frame.voxels() - 1);
}

}  // namespace
}  // namespace homolog
