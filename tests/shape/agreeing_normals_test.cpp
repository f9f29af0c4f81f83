// SPDX-License-Identifier: MIT
#include "homolog/shape/agreeing_normals.h"

#include <gtest/gtest.h>

#include "shape/clouds.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

std::size_t count_turned(const PointCloud& cloud, const std::vector<Vec3>& right) {
  std::size_t turned = 0;
  for (std::size_t i = 0; i < right.size(); ++i) turned += cloud.normals[i] != right[i];
  return turned;
}

TEST(AgreeingNormals, TurnBackThoseThatWereTurnedOver) {
  const PointCloud right = clouds::sampled(meshes::sphere(4), 2000);
  for (const std::size_t one_of : {100, 50, 10}) {
    PointCloud cloud = right;
    for (std::size_t i = 0; i < cloud.normals.size(); i += one_of) cloud.normals[i] *= -1;
    turn_overruled(cloud);
    EXPECT_LE(count_turned(cloud, right.normals), one_of == 10 ? 10u : 0u) << one_of;  // of 200: five lie together by chance
  }
}

TEST(AgreeingNormals, StayWhereTheyAreRight) {
  for (const Mesh& mesh : {meshes::sphere(4), meshes::box({0, 0, 0}, {1, 1, 1})}) {
    PointCloud cloud = clouds::sampled(mesh, 2000);
    const std::vector<Vec3> right = cloud.normals;
    turn_overruled(cloud);
    EXPECT_EQ(cloud.normals, right);
  }
}

TEST(AgreeingNormals, StayOnBothSidesOfAThinPlate) {
  PointCloud cloud = clouds::sampled(meshes::box({0, 0, 0}, {1, 1, 0.001}), 4000);
  const std::vector<Vec3> right = cloud.normals;
  turn_overruled(cloud);
  EXPECT_LT(count_turned(cloud, right), 20u);  // 20 of 24 that were drawn by chance look one way once in 600 times
}

TEST(AgreeingNormals, OneOrNoneIsLeftAsItIs) {
  PointCloud one{{{1, 2, 3}}, {{0, 0, 2}}}, none;
  turn_overruled(one);
  turn_overruled(none);
  EXPECT_EQ(one.normals[0], Vec3(0, 0, 2));
}

}  // namespace
}  // namespace homolog
