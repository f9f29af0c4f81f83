// SPDX-License-Identifier: MIT
#include "homolog/shape/label_surface.h"

#include <gtest/gtest.h>

#include <functional>

#include "homolog/shape/orient.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

using Solid = std::function<bool(int x, int y, int z)>;

RawVolume volume_of(const Solid& solid) {
  constexpr int side = 44;
  RawVolume volume;
  volume.size = {side, side, side};
  volume.type = NumberType::uint8;
  for (int i = 0; i < side * side * side; ++i) volume.bytes += static_cast<char>(solid(i % side, i / side % side, i / side / side));
  return volume;
}

/// Of the surface, as a share of the voxels inside it.
double volume_kept(const Solid& solid) {
  const RawVolume volume = volume_of(solid);
  const Mesh mesh = label_surface(volume, {}, "a.nii");
  EXPECT_TRUE(orient(mesh).closed());
  return meshes::volume(mesh) / static_cast<double>(std::count(volume.bytes.begin(), volume.bytes.end(), 1));
}

Solid box(int x_side, int y_side, int z_side) {
  return [=](int x, int y, int z) { return x >= 2 && x < 2 + x_side && y >= 2 && y < 2 + y_side && z >= 2 && z < 2 + z_side; };
}

Solid ball(double radius) {
  return [=](int x, int y, int z) { return Vec3(x - 20, y - 20, z - 20).norm() <= radius; };
}

TEST(LabelSurface, WhatIsOneVoxelThickKeepsTheVolumeOfItsVoxels) {
  for (const Solid& thin : {box(1, 1, 1), box(1, 1, 40), box(40, 1, 1), box(30, 30, 1), ball(1), ball(1.5)}) {
    EXPECT_NEAR(volume_kept(thin), 1, 1e-9);
  }
  const Solid slanting = [](int x, int y, int z) { return x < 40 && y == 2 + x / 2 && z == 2 + x / 3; };
  EXPECT_NEAR(volume_kept(slanting), 1, 1e-9);
}

TEST(LabelSurface, WhatIsThickerKeepsMostOfIt) {
  EXPECT_GT(volume_kept(box(2, 2, 40)), 0.6);
  EXPECT_GT(volume_kept(ball(2)), 0.7);
  for (const double radius : {3.0, 4.0, 6.0, 15.0}) EXPECT_NEAR(volume_kept(ball(radius)), 1, 0.15);
}

TEST(LabelSurface, ARodKeepsItsVolumeOnABody) {
  const Solid body = ball(8);
  const Solid both = [&](int x, int y, int z) { return body(x, y, z) || (x == 20 && y == 20 && z >= 20 && z < 43); };
  const double voxels = 14;  // of the rod, beyond the ball's pole at 28
  const double rod =
      meshes::volume(label_surface(volume_of(both), {}, "a.nii")) - meshes::volume(label_surface(volume_of(body), {}, "a.nii"));
  EXPECT_NEAR(rod, voxels, 2);
}

TEST(LabelSurface, OneVoxelTooManyIsSmoothedAway) {
  const Solid with_one = [](int x, int y, int z) { return box(20, 20, 20)(x, y, z) || (x == 12 && y == 12 && z == 22); };
  EXPECT_LT(bounding_box(label_surface(volume_of(with_one), {}, "a.nii")).max.z(), 22.2);  // a whole one ends at 22.5
}

}  // namespace
}  // namespace homolog
