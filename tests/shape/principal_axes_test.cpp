// SPDX-License-Identifier: MIT
#include "homolog/shape/principal_axes.h"

#include <gtest/gtest.h>

#include "fixtures/shapes.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

using namespace fixtures;

TEST(PrincipalAxes, OfABoxAreItsSides) {
  const Mesh box = mesh_of(fixtures::box({3, 4, 5}, {1, 0.2, 0.5}), 60);
  const Mat3 axes = principal_axes(box);
  EXPECT_NEAR(std::abs(axes(0, 0)), 1, 1e-3);
  EXPECT_NEAR(std::abs(axes(1, 2)), 1, 1e-3);  // the shortest side last
  EXPECT_NEAR(axes.determinant(), 1, 1e-12);
}

TEST(PrincipalAxes, TurnWithTheShapeWhateverItsSizeAndPlace) {
  const Mesh hand = mesh_of(fixtures::hand(), 40);
  const Mat3 axes = principal_axes(hand);
  for (const double scale : {1e-3, 1.0, 1e3}) {
    const fixtures::Similarity move{random_rotation(7), scale, scale * Vec3(5, -7, 3)};
    Mesh other = hand;
    for (Vec3& v : other.vertices) v = move(v);
    EXPECT_TRUE(principal_axes(other).isApprox(move.rotation * axes, 1e-6)) << scale;
  }
}

// Where any axes would do rounding must not choose them.
TEST(PrincipalAxes, AreTheSameForACubeAPrismAndAPlateHoweverTheirNumbersAreRounded) {
  for (const Vec3& sides : {Vec3(1, 1, 1), Vec3(1, 3, 1), Vec3(2, 0.5, 2)}) {
    const Mesh box = meshes::box(Vec3::Zero(), sides);
    const Mat3 axes = principal_axes(box);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(axes.col(k).cwiseAbs().maxCoeff(), 1, 1e-9) << sides.transpose();
    for (const double scale : {1.0, 25.4, 1 / 3.0}) {
      Mesh other = box;
      for (Vec3& v : other.vertices) v = scale * (v + Vec3(0.1, 0.2, 0.3));
      EXPECT_TRUE(principal_axes(other).cwiseAbs().isApprox(axes.cwiseAbs(), 1e-4)) << sides.transpose() << " times " << scale;
    }
  }
}

TEST(PrincipalAxes, AreARotationForAPrismAndAPlateHoweverTheyAreTurned) {
  const std::pair<Vec3, int> solids[] = {{Vec3(1, 3, 1), 0}, {Vec3(2, 0.5, 2), 2}};  // sides, and which axis is along y
  for (const auto& [sides, along] : solids) {
    for (const int seed : {1, 2, 3}) {
      const Mat3 turn = random_rotation(seed);
      const Mat3 axes = principal_axes(turned(meshes::box(Vec3::Zero(), sides), turn));
      EXPECT_TRUE((axes.transpose() * axes).isIdentity(1e-9)) << seed;
      EXPECT_NEAR(axes.determinant(), 1, 1e-9) << seed;
      EXPECT_NEAR(std::abs(axes.col(along).dot(turn.col(1))), 1, 1e-9) << seed;
    }
  }
}

TEST(PrincipalAxes, OfNothingAreThoseOfTheWorld) {
  EXPECT_EQ(principal_axes({}), Mat3::Identity());
  EXPECT_EQ(principal_axes({{Vec3::Zero(), Vec3::UnitX(), 2 * Vec3::UnitX()}, {{0, 1, 2}}}), Mat3::Identity());
}

}  // namespace
}  // namespace homolog
