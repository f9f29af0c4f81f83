// SPDX-License-Identifier: MIT
#include "homolog/shape/thicken.h"

#include <gtest/gtest.h>

#include "fixtures/solids.h"
#include "homolog/base/errors.h"
#include "homolog/shape/voxelize.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

const Mesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};

TEST(Thicken, GivesASheetItsVolume) {  // a plate, half a cylinder along each edge, an eighth of a ball at each corner
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    for (const double thicken : {0.01, 0.05, 0.1}) {
      const Mesh sheet = meshes::moved(square, fixtures::random_rotation(seed));
      const double t = thicken * bounding_box(sheet).diagonal();
      const Voxels voxels = voxelize(sheet, 96, {}, thicken);
      EXPECT_NEAR(meshes::volume(voxels.interior) / (t + M_PI * t * t / 2 + M_PI * t * t * t / 6), 1, 0.04) << seed << " " << thicken;
    }
  }
}

TEST(Thicken, GrowsASolidByHalf) {
  const double thicken = 0.05, radius = 1 + thicken * std::sqrt(12) / 2;
  const Voxels voxels = voxelize(meshes::sphere(5), 64, {}, thicken);
  EXPECT_NEAR(meshes::volume(voxels.interior) / (4 * M_PI / 3 * std::pow(radius, 3)), 1, 5e-3);
  EXPECT_EQ(voxels.interior.frame.size[0], 66);
  EXPECT_NEAR(voxels.interior.frame.spacing, 2 * radius / 64, 1e-3);
}

TEST(Thicken, IsCutToThePart) {
  const double half = 0.05 * std::sqrt(2) / 2;
  const Voxels voxels = voxelize(square, 64, Box{{0, 0, 0}, {0.5, 1, 1}}, 0.05);
  const auto& frame = voxels.interior.frame;
  EXPECT_NEAR(frame.world_from_voxel(Vec3(frame.size[0] - 1.5, 0, 0)).x(), 0.5, 1e-9);
  EXPECT_NEAR(frame.world_from_voxel(Vec3(0.5, 0, 0)).x(), -half, 1e-2);
  EXPECT_NEAR(sample(voxels.interior, {0.25, 0.5, 0}), 1, 1e-6);
}

TEST(Thicken, OutOfRangeIsAnError) {
  EXPECT_THROW(voxelize(square, 32, {}, -0.1), ParamError);
  EXPECT_THROW(voxelize(square, 32, {}, 1.1), ParamError);
}

}  // namespace
}  // namespace homolog
