// SPDX-License-Identifier: MIT
#include "homolog/shape/surface_nets.h"

#include <gtest/gtest.h>

#include "homolog/shape/orient.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

/// A ball of zeros and ones, or with a slope of one per voxel across its surface.
SliceField ball(int size, const Vec3& centre, double radius, bool sharp) {
  return {{size, size, size}, [=](int z, std::vector<float>& slice) {
            for (int y = 0; y < size; ++y) {
              for (int x = 0; x < size; ++x) {
                const double within = radius - (Vec3(x, y, z) - centre).norm();
                slice[static_cast<std::size_t>(y * size + x)] = static_cast<float>(sharp ? within > 0 : std::clamp(within + 0.5, 0.0, 1.0));
              }
            }
          }};
}

TEST(SurfaceNets, ABallKeepsItsVolumeAndRoundness) {
  const Vec3 centre(20.3, 19.6, 20);
  for (const bool sharp : {true, false}) {
    const Mesh mesh = surface_nets(ball(41, centre, 15, sharp), 20);
    EXPECT_TRUE(orient(mesh).closed());
    EXPECT_EQ(orient(mesh).triangles, mesh.triangles);  // its front is outside
    EXPECT_NEAR(meshes::volume(mesh) / (4 * M_PI / 3 * 15 * 15 * 15), 1, 0.02);
    double farthest = 0;
    for (const Vec3& vertex : mesh.vertices) farthest = std::max(farthest, std::abs((vertex - centre).norm() - 15));
    EXPECT_LT(farthest, 0.6);
  }
}

TEST(SurfaceNets, SolidsOfAnyShapeAreClosed) {  // voxels drawn by lot touch at edges and corners, and at the border of the grid
  const int size = 9;
  const SliceField lots{{size, size, size}, [=](int z, std::vector<float>& slice) {
                          for (std::size_t i = 0; i < slice.size(); ++i)
                            slice[i] = (i * 7919 + static_cast<std::size_t>(z) * 104729) % 5 < 2;
                        }};
  std::vector<float> slice(size * size);
  double voxels = 0;
  for (int z = 0; z < size; ++z) {
    lots.fill(z, slice);
    for (const float value : slice) voxels += value;
  }
  const Mesh mesh = surface_nets(lots, 0);
  EXPECT_GT(meshes::volume(mesh), 0);
  EXPECT_LT(meshes::volume(mesh), voxels);
  EXPECT_TRUE(orient(mesh).closed());
}

TEST(SurfaceNets, NothingGivesNothing) { EXPECT_TRUE(surface_nets(ball(5, Vec3::Zero(), -1, true), 5).triangles.empty()); }

}  // namespace
}  // namespace homolog
