// SPDX-License-Identifier: MIT
// Sec. 4.3, eq. 2 and 3: p points away from the inside around a point.
#include "homolog/salient/direction.h"

#include <gtest/gtest.h>

#include "fixtures/solids.h"

namespace homolog {
namespace {

using namespace fixtures;

SalientPoint point_at(const Vec3& x, double r) {
  SalientPoint p;
  p.position = x;
  p.radius = r;
  return p;
}

// Inside a half-space x.n < 0 a ball around a point of its surface has its centre of mass at 3/8 of the ball's radius below.
TEST(Direction, HalfSpaceGivesItsNormalAndThreeEighths) {
  const GridFrame frame{{81, 81, 81}, Vec3::Constant(-40), 1};
  const Vec3 normal = Vec3(1, 2, -0.5).normalized();
  const Solid half_space = {{[=](const Vec3& x) { return normal.dot(x); }, [](const Vec3&) { return 0.0; }}};
  const Interior interior = rasterize(half_space, frame);
  SalientParams params;
  for (const double r : {3.0, 8.0, 19.0}) {
    std::vector<SalientPoint> points = {point_at({0, 0, 0}, r)};
    find_directions(interior, params, points);
    EXPECT_GT(points[0].direction.dot(normal), 0.9995) << r;
    EXPECT_NEAR(points[0].direction_length, 0.375 * params.direction_radius, 0.01) << r;
  }
}

// Large balls look at every n-th voxel: as good as the plain mean of all, weighed whole where their centres lie in the ball.
TEST(Direction, IsTheMeanOfAllVoxelsInTheBall) {
  const Solid solid = join({capsule({0, 0, 0}, {30, 10, 4}, 9), ball({4, 14, -6}, 11)});
  const Interior interior = rasterize(solid, 100);
  const double spacing = interior.frame.spacing;
  SalientParams params;
  for (const double r : {20 * spacing / params.direction_radius, 45 * spacing / params.direction_radius}) {
    std::vector<SalientPoint> points = {point_at({8, 9, 0}, r)};
    find_directions(interior, params, points);
    Vec3 moment = Vec3::Zero();
    double mass = 0;
    for (int k = 0; k < interior.frame.size[2]; ++k) {
      for (int j = 0; j < interior.frame.size[1]; ++j) {
        for (int i = 0; i < interior.frame.size[0]; ++i) {
          const Vec3 offset = interior.frame.world_from_voxel(Vec3(i, j, k)) - points[0].position;
          if (offset.norm() < params.direction_radius * r) mass += interior.at(i, j, k), moment += interior.at(i, j, k) * offset;
        }
      }
    }
    const Vec3 away = -moment / (mass * r);
    EXPECT_GT(points[0].direction.dot(away.normalized()), 0.9995) << r;
    EXPECT_NEAR(points[0].direction_length, away.norm(), 0.01) << r;
  }
}

TEST(Direction, FingerTipPointsOutAlongTheFinger) {
  const Vec3 along = Vec3(1, 0.5, 0.2).normalized();
  const Solid finger = capsule(Vec3::Zero(), 40 * along, 6);
  std::vector<SalientPoint> points = {point_at(38 * along, 6.5)};
  find_directions(rasterize(finger, 60), {}, points);
  EXPECT_GT(points[0].direction.dot(along), 0.999);
  EXPECT_GT(points[0].direction_length, 0.3);
}

// Nothing tells a direction in the middle of a ball: length 0, still a unit vector; the point stays.
TEST(Direction, BallHasNone) {
  std::vector<SalientPoint> points = {point_at({0.2, 0.1, 0}, 10)};
  find_directions(rasterize(ball({0.2, 0.1, 0}, 10), 40), {}, points);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].direction_length, 0);
  EXPECT_NEAR(points[0].direction.norm(), 1, 1e-12);
}

TEST(Direction, EmptyNeighbourhoodKeepsTheDefault) {
  std::vector<SalientPoint> points = {point_at({100, 0, 0}, 2)};
  find_directions(rasterize(ball({0, 0, 0}, 10), 40), {}, points);
  EXPECT_EQ(points[0].direction, Vec3(Vec3::UnitZ()));
  EXPECT_EQ(points[0].direction_length, 0);
}

}  // namespace
}  // namespace homolog
