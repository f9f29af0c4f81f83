// SPDX-License-Identifier: MIT
#include "homolog/match/chamfer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace homolog {
namespace {

// A cube of full voxels [8, 16)^3 in a grid of 24^3 with spacing 0.5, and its distances, which are known in closed form.
GridFrame frame() { return {{24, 24, 24}, Vec3(-1, 2, 3), 0.5}; }
bool inside(int i) { return i >= 8 && i < 16; }
Interior cube() {
  Interior interior{frame(), std::vector<float>(frame().voxels(), 0)};
  for (int k = 0; k < 24; ++k) {
    for (int j = 0; j < 24; ++j) {
      for (int i = 0; i < 24; ++i) interior.at(i, j, k) = inside(i) && inside(j) && inside(k) ? 1 : 0;
    }
  }
  return interior;
}

const InsideTree& cube_distance() {
  static const Interior interior = cube();
  static const InsideTree tree(interior);
  return tree;
}

Vec3 identity(const Vec3& x) { return x; }

TEST(Sec623, AShapeMappedOntoItselfHasNoDistance) {
  EXPECT_EQ(chamfer_distance(sample_interior(cube(), 12), identity, cube_distance(), 1), 0);
}

TEST(Sec623, DistancesAccumulateOverTheInterior) {
  const auto aside = [](const Vec3& x) -> Vec3 { return x + Vec3(1.5, 0, 0); };  // three voxels: layers miss by 3, 2, 1, 0, 0, ... voxels
  const double d_c = chamfer_distance(sample_interior(cube(), 24), aside, cube_distance(), 10);
  EXPECT_NEAR(d_c, 0.5 * (3 + 2 + 1) / 8 / 10, 1e-7);
}

TEST(Chamfer, DistanceBetweenVoxelsIsTrilinear) {
  const InsideTree& distance = cube_distance();
  EXPECT_NEAR(distance_at(distance, frame().world_from_voxel(Vec3(5.25, 10, 10))), 0.5 * 2.75, 1e-6);
  EXPECT_NEAR(distance_at(distance, frame().world_from_voxel(Vec3(23, 10, 10))), 0.5 * 8, 1e-6);
}

TEST(Chamfer, OutsideTheGridTheWayToItIsAdded) {
  EXPECT_NEAR(distance_at(cube_distance(), frame().world_from_voxel(Vec3(33, 10, 10))), 0.5 * (8 + 10), 1e-6);
  EXPECT_TRUE(std::isinf(distance_at(cube_distance(), Vec3(NAN, 0, 0))));
}

TEST(Chamfer, DataWithoutInsideIsInfinitelyFar) {
  const Interior empty{frame(), std::vector<float>(frame().voxels(), 0)};
  EXPECT_TRUE(std::isinf(chamfer_distance(sample_interior(cube(), 12), identity, InsideTree(empty), 1)));
}

TEST(Chamfer, NothingCoveredIsInfinitelyFar) { EXPECT_TRUE(std::isinf(chamfer_distance({}, identity, cube_distance(), 1))); }

TEST(Chamfer, SamplesKeepAllTheVolumeOnAnyLattice) {
  for (const int cells : {1, 5, 7, 24, 100}) {
    double volume = 0;
    for (const auto& sample : sample_interior(cube(), cells)) {
      volume += sample.weight;
      EXPECT_EQ(distance_at(cube_distance(), sample.position), 0);  // every sample lies inside
    }
    EXPECT_NEAR(volume, 512, 1e-9) << cells;
  }
}

TEST(Chamfer, OnlyTheCoveredPartCounts) {
  const auto samples = sample_interior(cube(), 24);
  SalientPoint corner;
  corner.position = frame().world_from_voxel(Vec3(8, 8, 8));
  corner.radius = 0.5;
  EXPECT_EQ(covered_samples(samples, {corner}, 1).size(), 4u);  // itself and a neighbour along each axis
  EXPECT_EQ(covered_samples(samples, {corner}, 100).size(), samples.size());
  EXPECT_TRUE(covered_samples(samples, {}, 100).empty());
}

}  // namespace
}  // namespace homolog
