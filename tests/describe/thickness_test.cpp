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

}  // namespace
}  // namespace homolog
