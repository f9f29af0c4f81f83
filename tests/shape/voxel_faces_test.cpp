// SPDX-License-Identifier: MIT
#include "homolog/shape/voxel_faces.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <random>

#include "homolog/base/errors.h"
#include "homolog/shape/label_surface.h"

namespace homolog {
namespace {

using testing::HasSubstr;
using Inside = std::function<bool(int x, int y, int z)>;

SolidVoxels solid_of(int side, const Inside& inside) {
  SolidVoxels solid{{side, side, side}, {}};
  for (int z = 0; z < side; ++z) {
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) solid.inside.push_back(inside(x, y, z));
    }
  }
  return solid;
}

/// Each voxel is inside with this probability.
SolidVoxels noise(int side, double probability) {
  std::mt19937 random(1);
  return solid_of(side, [&](int, int, int) { return random() < probability * 4294967296.0; });
}

bool scattered(const SolidVoxels& solid) { return are_scattered(solid, voxel_faces(solid)); }

RawVolume volume_of(const SolidVoxels& solid) {
  RawVolume volume;
  for (int axis = 0; axis < 3; ++axis) volume.size[axis] = solid.size[axis];
  for (const bool inside : solid.inside) volume.bytes += inside ? '\1' : '\0';
  return volume;
}

std::string refusal(const SolidVoxels& solid, std::size_t most_triangles = 50'000'000) {
  try {
    label_surface(volume_of(solid), 1, "a.nii", most_triangles);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

TEST(VoxelFaces, AreTwoTrianglesEach) {
  const Inside ball = [](int x, int y, int z) { return std::hypot(x - 10, y - 9, z - 11) < 7.5; };
  for (const Inside& inside :
       {ball, Inside([](int, int, int) { return true; }), Inside([](int x, int y, int z) { return x + y + z == 30; })}) {
    const SolidVoxels solid = solid_of(21, inside);
    EXPECT_EQ(label_surface(volume_of(solid), 1, "a.nii").triangles.size(), voxel_faces(solid).triangles());
  }
}

TEST(VoxelFaces, NoiseIsScatteredAndNoShapeIs) {
  for (const double probability : {0.01, 0.1, 0.5, 0.9, 0.99}) EXPECT_TRUE(scattered(noise(80, probability))) << probability;
  EXPECT_FALSE(scattered(solid_of(20, [](int, int, int) { return true; })));
  EXPECT_FALSE(scattered(solid_of(60, [](int x, int y, int z) { return std::abs(std::hypot(x - 30, y - 30, z - 30) - 25) < 0.5; })));
  EXPECT_FALSE(scattered(solid_of(60, [](int x, int y, int) { return x % 3 == 0 && y % 3 == 0; }))) << "a bundle of rods";
  const SolidVoxels specks = noise(60, 0.01);
  EXPECT_FALSE(scattered(solid_of(60, [&](int x, int y, int z) { return (x < 30) != specks.at(x, y, z); }))) << "a wall among specks";
}

TEST(VoxelFaces, MuchNoiseIsRefusedBeforeItsSurfaceIsMade) {
  EXPECT_THAT(refusal(noise(70, 0.5)), HasSubstr("a.nii: its voxels are scattered as noise is, with 10"));
  EXPECT_EQ(refusal(noise(20, 0.5)), "");
}

TEST(VoxelFaces, SurfacesThatAreTooLargeAreRefusedBeforeTheyAreMade) {
  const SolidVoxels block = solid_of(10, [](int, int, int) { return true; });
  EXPECT_EQ(refusal(block, 1200), "");
  EXPECT_THAT(refusal(block, 1199), HasSubstr("a.nii: the surface of its voxels has 1200 triangles, more than the 1199 that are read"));
}

}  // namespace
}  // namespace homolog
