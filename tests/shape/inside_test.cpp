// SPDX-License-Identifier: MIT
// Broken surfaces: what voxelize() finds inside them, against the solid they come from.
#include "homolog/shape/inside.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "fixtures/solids.h"
#include "homolog/base/errors.h"
#include "homolog/base/parallel.h"
#include "homolog/shape/axis_sums.h"
#include "homolog/shape/settle_by_winding.h"
#include "homolog/shape/voxelize.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

/// Every triangle with its own corners, a share of them missing and another one turned.
Mesh soup_of(const Mesh& mesh, unsigned missing_percent, unsigned turned_percent) {
  std::mt19937 random(7);
  Mesh soup;
  for (const auto& triangle : mesh.triangles) {
    if (random() % 100 < missing_percent) continue;
    const auto n = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t corner : triangle) soup.vertices.push_back(mesh.vertices[corner]);
    const bool turned = random() % 100 < turned_percent;
    soup.triangles.push_back({n, turned ? n + 2 : n + 1, turned ? n + 1 : n + 2});
  }
  return soup;
}

/// Share of the volume of both that only one of the two has, on the grid of the first.
double difference(const Interior& a, const Interior& b) {
  double apart = 0, both = 0;
  for (int k = 0; k < a.frame.size[2]; ++k) {
    for (int j = 0; j < a.frame.size[1]; ++j) {
      for (int i = 0; i < a.frame.size[0]; ++i) {
        const float there = sample(b, a.frame.world_from_voxel({i + 0., j + 0., k + 0.}));
        apart += std::abs(a.at(i, j, k) - there);
        both += std::max(a.at(i, j, k), there);
      }
    }
  }
  return apart / both;
}

TEST(Inside, OfASoupIsThatOfItsSolid) {
  const Mesh solids[] = {meshes::torus(1, 0.3, 80, 40),
                         meshes::moved(fixtures::mesh_of(fixtures::hand(), 48), fixtures::random_rotation(4))};
  for (const Mesh& solid : solids) {
    const Interior whole = voxelize(solid, 64).interior;
    for (const auto& [missing, turned] : {std::pair{0u, 30u}, {10u, 0u}, {10u, 30u}}) {
      const Voxels voxels = voxelize(soup_of(solid, missing, turned), 64);
      EXPECT_LT(difference(whole, voxels.interior), missing == 0 ? 1e-6 : 0.03) << missing << " " << turned;
      EXPECT_EQ(voxels.open > 0, missing > 0);
    }
  }
}

TEST(Inside, IsClosedOverAHole) {  // a ball without a cap: about its plane is inside what lies below it
  Mesh ball = meshes::moved(meshes::sphere(5), fixtures::random_rotation(3));
  const Vec3 up = fixtures::random_rotation(3).col(2);
  std::erase_if(ball.triangles, [&](const auto& t) { return ball.vertices[t[0]].dot(up) > 0.8; });
  const Voxels voxels = voxelize(ball, 64);
  EXPECT_NEAR(meshes::volume(voxels.interior) / (4 * M_PI / 3), 1, 0.05);
  EXPECT_GT(voxels.guessed, 0);
  EXPECT_EQ(sample(voxels.interior, 0.9 * up), 0);
  EXPECT_EQ(sample(voxels.interior, 0.5 * up), 1);
}

TEST(Inside, OfSheetsIsNothing) {
  const Mesh wall{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.3}, {0, 1, 0.2}}, {{0, 1, 2}, {0, 2, 3}}};
  for (const Mesh& sheet : {wall, meshes::joined(wall, meshes::reversed(wall))}) {
    try {
      voxelize(sheet, 32);
      FAIL() << "a sheet has no inside";
    } catch (const ShapeError& error) {
      EXPECT_NE(std::string(error.what()).find("--thicken"), std::string::npos) << error.what();
    }
  }
  const Mesh ball = meshes::moved(meshes::sphere(4), Mat3::Identity() * 0.2, {0.5, 0.5, 1});
  const Mesh both = meshes::joined(ball, wall);
  EXPECT_NEAR(meshes::volume(voxelize(both, 64).interior) / meshes::volume(ball), 1, 1e-2);
}

TEST(Inside, OfOpenSurfacesDoesNotDependOnThreads) {
  const Mesh soup = soup_of(meshes::torus(1, 0.3, 40, 20), 20, 30);
  const Voxels many = voxelize(soup, 64);
  const ThreadLimit one(1);
  EXPECT_EQ(voxelize(soup, 64).interior.values, many.interior.values);
}

/// A pipe along x whose ends are open, so that rays along it say nothing, and a ball beside it; both within a grid.
GridSurface pipe_and_ball() {
  GridSurface surface{{37, 26, 27}, {}, {}, {Vec3::Zero(), {37, 26, 27}}};
  Mesh both = meshes::moved(meshes::sphere(3), 3.7 * Mat3::Identity(), {29.3, 12.1, 13.2});
  const auto first = static_cast<std::uint32_t>(both.vertices.size());
  for (std::uint32_t i = 0; i < 24; ++i) {
    for (const double x : {3.2, 22.9}) both.vertices.emplace_back(x, 13 + 6 * std::cos(M_PI * i / 12), 13 + 6 * std::sin(M_PI * i / 12));
    const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % 24);
    both.triangles.insert(both.triangles.end(), {{a, b + 1, a + 1}, {a, b, b + 1}});
  }
  surface.vertices = both.vertices;
  surface.triangles = both.triangles;
  return surface;
}

struct Means {
  std::vector<float> mean;
  std::vector<std::uint8_t> disputed;
};

/// What the three axes say of every voxel, one after the other.
Means means_of(const GridSurface& surface) {
  Means means{std::vector<float>(surface.voxels()), std::vector<std::uint8_t>(surface.voxels())};
  visit_axis_sums(surface, [&](const RowSums& row) {
    for (int x = 0; x < surface.size[0]; ++x) {
      const std::size_t voxel = (static_cast<std::size_t>(row.z) * surface.size[1] + row.y) * surface.size[0] + x;
      double share[3];
      for (int axis = 0; axis < 3; ++axis) share[axis] = static_cast<double>(row.sums[axis][x]) / full_coverage;
      means.mean[voxel] = static_cast<float>((share[0] + share[1] + share[2]) / 3);
      means.disputed[voxel] = std::max({share[0], share[1], share[2]}) - std::min({share[0], share[1], share[2]}) > 0.5;
      EXPECT_FALSE(row.any_lost);
    }
  });
  return means;
}

TEST(Inside, ByRaysIsTheMeanOfThreeAxes) {
  const GridSurface surface = pipe_and_ball();
  const std::vector<float> found = coverage_by_rays(surface), expected = means_of(surface).mean;
  for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], expected[i], 1e-6) << i;
}

TEST(Inside, OfAnOpenPipeIsTheMeanWhereAxesAgreeAndTheRestByWinding) {
  const GridSurface surface = pipe_and_ball();
  Means means = means_of(surface);
  for (std::size_t i = 0; i < means.mean.size(); ++i) {
    if (means.disputed[i]) means.mean[i] = 0;
  }
  EXPECT_GT(std::count(means.disputed.begin(), means.disputed.end(), 1), 1000);
  settle_by_winding(surface, means.disputed, means.mean);
  double all = 0, guessed = 0;
  for (std::size_t i = 0; i < means.mean.size(); ++i) {
    all += means.mean[i];
    if (means.disputed[i]) guessed += means.mean[i];
  }
  const Inside found = inside_of_open(surface);
  for (std::size_t i = 0; i < found.coverage.size(); ++i) ASSERT_NEAR(found.coverage[i], means.mean[i], 1e-6) << i;
  EXPECT_NEAR(found.guessed, guessed / all, 1e-6);
}

}  // namespace
}  // namespace homolog
