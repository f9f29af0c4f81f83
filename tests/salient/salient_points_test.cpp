// SPDX-License-Identifier: MIT
// Sec. 4.2, 4.3: what balls, cylinders, plates and half-spaces answer, and where salient points stand.
#include "homolog/salient/salient_points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fixtures/solids.h"
#include "homolog/base/parallel.h"
#include "homolog/salient/scale_space.h"

namespace homolog {
namespace {

using namespace fixtures;

// A grid of unit voxels around the origin.
GridFrame unit_grid(int half) { return {{2 * half + 1, 2 * half + 1, 2 * half + 1}, Vec3::Constant(-half), 1}; }

TEST(SalientPoints, RadiusOfABallIsRightWithinHalfAPercent) {
  const SalientParams params;
  for (const double r : {4.0, 5.0, 7.0, 10.0, 16.0, 26.0}) {
    const int jitters = r < 12 ? 6 : 3;
    double sum = 0;
    for (int n = 0; n < jitters; ++n) {
      const Vec3 centre = random_rotation(n) * Vec3(0.4, 0.25, 0.1);
      const auto points = find_salient_points(rasterize(ball(centre, r), unit_grid(static_cast<int>(r) + 2)), params);
      ASSERT_EQ(points.size(), 1u) << r;
      EXPECT_NEAR(points[0].radius / r, 1, 0.01) << r;
      EXPECT_NEAR(points[0].response, 1, 0.02) << r;
      EXPECT_LT((points[0].position - centre).norm(), 0.02 * r) << r;
      sum += points[0].radius / r;
    }
    EXPECT_NEAR(sum / jitters, 1, 0.005) << r;
  }
}

}  // namespace
}  // namespace homolog
