// SPDX-License-Identifier: MIT
// Sec. 4.3: one value of the scale space, without the scale space.
#include "homolog/salient/response_at.h"

#include <gtest/gtest.h>

#include "fixtures/shapes.h"
#include "homolog/describe/turn_shape.h"

namespace homolog {
namespace {

using namespace fixtures;

TEST(ResponseAt, ABallAnswersOneInItsCentreAtItsOwnScale) {
  const Shape shape = described(ball({0.3, -0.2, 0.1}, 0.5));
  const SalientParams params = coarse().salient;
  EXPECT_NEAR(response_at(shape.interior, {0.3, -0.2, 0.1}, 0.5, params), 1, 0.02);
  EXPECT_LT(response_at(shape.interior, {0.3, -0.2, 0.1}, 0.3, params), 0.9);
  EXPECT_LT(response_at(shape.interior, {0.6, -0.2, 0.1}, 0.5, params), 0.9);
  EXPECT_EQ(response_at(shape.interior, {9, 9, 9}, 0.5, params), 0);
}

TEST(ResponseAt, SalientPointsAnswerAsInTheScaleSpace) {
  double sum = 0;
  for (const SalientPoint& point : described_hand().points) {
    const double missed = response_at(described_hand().interior, point.position, point.radius, coarse().salient) - point.response;
    EXPECT_LT(std::abs(missed), 0.05);  // where a minimum is flat, refinement takes a parabola for it
    sum += std::abs(missed);
  }
  EXPECT_LT(sum / static_cast<double>(described_hand().points.size()), 0.01);
}

TEST(ResponseAt, TurnsWithTheShape) {
  Shape turned = described_hand();
  const SalientPoint before = turned.points.front();
  turn_shape(turned, Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix());
  EXPECT_NEAR(response_at(turned.interior, turned.points.front().position, before.radius, coarse().salient),
              response_at(described_hand().interior, before.position, before.radius, coarse().salient), 1e-6);
}

}  // namespace
}  // namespace homolog
