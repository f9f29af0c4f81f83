// SPDX-License-Identifier: MIT
#include "homolog/shape/splats.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "homolog/shape/winding_number.h"
#include "shape/clouds.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

TEST(Splats, AreasOfALatticeAreThoseOfItsCells) {
  PointCloud lattice;
  for (int x = 0; x < 20; ++x) {
    for (int y = 0; y < 20; ++y) {
      lattice.points.emplace_back(2 * x, 3 * y, 0);
      lattice.normals.emplace_back(Vec3::UnitZ());
    }
  }
  const std::vector<double> areas = point_areas(lattice);
  for (int x = 3; x < 17; ++x) {
    for (int y = 3; y < 17; ++y) EXPECT_NEAR(areas[20 * x + y], 6, 1e-9);
  }
}

TEST(Splats, AreasOfASphereSumUpToItsOwn) {
  const PointCloud cloud = clouds::sampled(meshes::sphere(5), 4000);
  const std::vector<double> areas = point_areas(cloud);
  EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0) / (4 * M_PI), 1, 0.02);
}

TEST(Splats, NeighboursOnTheOtherSideOfASheetTakeNothing) {
  const PointCloud plate = clouds::sampled(meshes::box({0, 0, 0}, {1, 1, 0.001}), 2000);
  const std::vector<double> areas = point_areas(plate);
  double inner = 0, count = 0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if ((plate.points[i].head<2>().array() - 0.5).abs().maxCoeff() > 0.35) continue;
    inner += areas[i];
    ++count;
  }
  EXPECT_NEAR(inner / count, 2.0 / 2000, 0.1 * 2.0 / 2000);
}

TEST(Splats, ThinnedPointsAreMeansOfThoseThatLookTheSameWay) {
  const Vec3 up = Vec3::UnitZ();
  const PointCloud thin = thinned({{{0, 0, 0}, {0.5, 0, 0}, {0.5, 0, 0.25}, {3, 0, 0}}, {up, 2 * up, -up, up}}, 1);
  EXPECT_EQ(thin.points, (std::vector<Vec3>{{0.25, 0, 0}, {0.5, 0, 0.25}, {3, 0, 0}}));
  EXPECT_EQ(thin.normals, (std::vector<Vec3>{up, -up, up}));
}

TEST(Splats, WindAsTheirSurfaceDoes) {
  const PointCloud cloud = clouds::sampled(meshes::torus(1, 0.3, 60, 30), 6000);
  const Mesh mesh = triangles_about(cloud, point_areas(cloud));
  EXPECT_EQ(mesh.triangles.size(), cloud.points.size());
  const WindingNumber winding(mesh.vertices, mesh.triangles);
  for (double angle = 0; angle < 6; angle += 0.3) {
    const Vec3 outward(std::cos(angle), std::sin(angle), 0);
    for (const auto& [distance, turns] : {std::pair{0.0, 0}, {0.6, 0}, {0.85, 1}, {1.0, 1}, {1.15, 1}, {1.4, 0}}) {
      EXPECT_NEAR(winding.at(distance * outward), turns, 0.1) << angle << " " << distance;
    }
  }
}

}  // namespace
}  // namespace homolog
