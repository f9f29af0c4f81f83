// SPDX-License-Identifier: MIT
// Under the skin a ball is as thick as it is wide, and a plate as it is thin, whatever their size and turn.
#include "homolog/describe/thickness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fixtures/shapes.h"

namespace homolog {
namespace {

using namespace fixtures;

TEST(Thickness, OfABallIsItsDiameter) {
  for (const double radius : {1.0, 30.0}) {
    const Shape shape = described(ball({5, -7, 2}, radius));
    ASSERT_EQ(shape.thickness.size(), shape.surface.size());
    for (const double thickness : shape.thickness) EXPECT_NEAR(thickness, 2 * radius, 2 * shape.interior.frame.spacing);
  }
}

TEST(Thickness, OfAPlateIsThatBetweenItsFaces) {
  const Shape shape = described(moved(box(Vec3::Zero(), {1, 0.8, 0.1}), {random_rotation(3), 1, Vec3::Zero()}));
  const Vec3 across = random_rotation(3) * Vec3::UnitZ();
  for (std::size_t i = 0; i < shape.surface.size(); ++i) {
    if (std::abs(shape.surface[i].normal.dot(across)) < 0.99) continue;  // on an edge or a side
    EXPECT_NEAR(shape.thickness[i], 0.2, 2 * shape.interior.frame.spacing);
  }
}

// Where the solid ends, by steps a fiftieth of a voxel wide; thickness_at() looks at every half voxel.
TEST(Thickness, IsThatOfAFineMarch) {
  const Shape& shape = described_hand();
  const double voxel = shape.interior.frame.spacing;
  int apart = 0;
  for (std::size_t i = 0; i < shape.surface.size(); ++i) {
    double way = 1.5 * voxel;
    while (sample(shape.interior, shape.surface[i].position - way * shape.surface[i].normal) > 0.5f) way += 0.02 * voxel;
    EXPECT_GT(shape.thickness[i], way - 0.03 * voxel) << i;  // never ends before the solid does
    apart += shape.thickness[i] > way + 0.5 * voxel;
  }
  EXPECT_LT(apart, 0.01 * static_cast<double>(shape.surface.size()));  // ways that leave the solid for less than half a voxel
}

}  // namespace
}  // namespace homolog
