// SPDX-License-Identifier: MIT
#include "homolog/shape/cloud_surface.h"

#include <gtest/gtest.h>

#include "fixtures/solids.h"
#include "homolog/base/errors.h"
#include "homolog/base/parallel.h"
#include "homolog/salient/salient_points.h"
#include "homolog/shape/orient.h"
#include "homolog/shape/voxelize.h"
#include "shape/clouds.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

/// Long and thin, so that its grid is small.
Mesh capsule() { return fixtures::mesh_of(fixtures::capsule({0, 0, 0}, {6, 0, 0}, 1), 80); }

std::string refusal(const PointCloud& cloud) {
  try {
    cloud_surface(cloud, "the cloud");
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

void expect_refusal(const PointCloud& cloud, const std::string& what) {
  EXPECT_NE(refusal(cloud).find(what), std::string::npos) << "it says: " << refusal(cloud);
}

/// Every salient point of the solid is found again within a tenth of its radius, its radius within a twentieth.
void expect_same_points(const fixtures::Solid& solid, std::size_t count) {
  const Mesh mesh = fixtures::mesh_of(solid, 80);
  const Mesh surface = cloud_surface(clouds::sampled(mesh, count), "the cloud");
  const auto expected = find_salient_points(voxelize(mesh, 48).interior, {}),
             found = find_salient_points(voxelize(surface, 48).interior, {});
  EXPECT_FALSE(expected.empty());
  for (const SalientPoint& p : expected) {
    EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                            [&](const SalientPoint& q) {
                              return (p.position - q.position).norm() < 0.1 * p.radius && std::abs(q.radius / p.radius - 1) < 0.05;
                            }))
        << p.position.transpose() << ", radius " << p.radius;
  }
}

TEST(CloudSurface, IsClosedAndWhereThePointsAre) {
  constexpr std::size_t count = 1000;
  const Mesh mesh = capsule(), surface = cloud_surface(clouds::sampled(mesh, count), "the cloud");
  EXPECT_TRUE(orient(surface).closed());
  EXPECT_NEAR(meshes::volume(surface) / meshes::volume(mesh), 1, 0.01);
  const double way_between_points = std::sqrt(M_PI * (4 + 12) / count);
  for (const Vec3& vertex : surface.vertices) {
    EXPECT_LT(std::abs(fixtures::distance(fixtures::capsule({0, 0, 0}, {6, 0, 0}, 1), vertex)), way_between_points / 2);
  }
}

TEST(CloudSurface, GivesTheSalientPointsOfTheMesh) {
  expect_same_points(fixtures::capsule({0, 0, 0}, {6, 0, 0}, 1), 1500);
  expect_same_points(fixtures::ball({1, 2, 3}, 1), 800);
  expect_same_points(fixtures::hand(), 3000);
}

TEST(CloudSurface, TurnsNormalsThatAllFaceInward) {
  PointCloud cloud = clouds::sampled(capsule(), 1000);
  const Mesh outward = cloud_surface(cloud, "the cloud");
  for (Vec3& normal : cloud.normals) normal = -3 * normal;
  EXPECT_NEAR(meshes::volume(cloud_surface(cloud, "the cloud")) / meshes::volume(outward), 1, 1e-9);
}

TEST(CloudSurface, MendsNormalsThatLookAwayFromTheirNeighbours) {
  const PointCloud right = clouds::sampled(capsule(), 2000);
  const double volume = meshes::volume(cloud_surface(right, "the cloud"));
  for (const std::size_t one_of : {1000, 50, 20, 10}) {
    PointCloud cloud = right;
    for (std::size_t i = 0; i < cloud.normals.size(); i += one_of) cloud.normals[i] *= -1;
    EXPECT_NEAR(meshes::volume(cloud_surface(cloud, "the cloud")) / volume, 1, 0.01) << one_of;
  }
}

TEST(CloudSurface, IsOpenWhereNoPointIsNear) {
  PointCloud cloud = clouds::sampled(capsule(), 1000), part;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (cloud.points[i].x() > 6) continue;  // one of the round ends was not scanned
    part.points.push_back(cloud.points[i]);
    part.normals.push_back(cloud.normals[i]);
  }
  const Mesh surface = cloud_surface(part, "the cloud");
  EXPECT_FALSE(orient(surface).closed());
  const Voxels voxels = voxelize(surface, 48);
  EXPECT_GT(voxels.guessed, 0);
  EXPECT_NEAR(meshes::volume(voxels.interior), M_PI * (6 + 2.0 / 3), 1.5);
}

TEST(CloudSurface, RefusesWhatHasNoInside) {
  PointCloud cloud = clouds::sampled(capsule(), 1000);
  for (std::size_t i = 0; i < cloud.normals.size(); i += 2) cloud.normals[i] = -cloud.normals[i];
  expect_refusal(cloud, "orient their normals outward");
  PointCloud sheet = clouds::sampled(meshes::box({0, 0, 0}, {4, 1, 1}), 1000);
  for (std::size_t i = 0; i < sheet.points.size(); ++i) sheet.points[i].z() = 0, sheet.normals[i] = Vec3::UnitZ();
  expect_refusal(sheet, "the points enclose 0 %");
  expect_refusal(clouds::sampled(capsule(), 30), "30 points, where they differ, are too few");
  expect_refusal({{{1, 1, 1}}, {{0, 0, 1}}}, "no extent");
  expect_refusal({{{-1e308, 0, 0}, {1e308, 0, 0}}, {{-1, 0, 0}, {1, 0, 0}}}, "too large for numbers");
}

TEST(CloudSurface, RefusesOutliersThatMakeTheRestTooSmall) {
  PointCloud cloud = clouds::sampled(capsule(), 1000);
  cloud.points.emplace_back(100, 0, 0);
  cloud.normals.emplace_back(1, 0, 0);
  expect_refusal(cloud, "remove the outliers");
  cloud.points.back().x() = 1e5;
  expect_refusal(cloud, "a few points lie far from all others");
}

TEST(CloudSurface, RefusesStraysThatWouldBeMuchOfTheSurface) {
  PointCloud cloud = clouds::sampled(capsule(), 4000);
  EXPECT_EQ(refusal(cloud), "");
  for (const Vec3& place : {Vec3(-3, 4, 4), Vec3(9, -4, 3), Vec3(3, 5, -3), Vec3(0, -5, -4)}) {
    cloud.points.push_back(place);
    cloud.normals.push_back(-place.normalized());
  }
  expect_refusal(cloud, "4 points stand far from all others");
}

TEST(CloudSurface, DoesNotDependOnTheNumberOfThreads) {
  const PointCloud cloud = clouds::sampled(capsule(), 1000);
  const Mesh many = cloud_surface(cloud, "the cloud");
  const ThreadLimit limit(1);
  const Mesh one = cloud_surface(cloud, "the cloud");
  EXPECT_EQ(many.vertices, one.vertices);
  EXPECT_EQ(many.triangles, one.triangles);
}

}  // namespace
}  // namespace homolog
