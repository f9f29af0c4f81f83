// SPDX-License-Identifier: MIT
// Sec. 4.2, 4.3: what balls, cylinders, plates and half-spaces answer.
#include "homolog/salient/scale_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fixtures/solids.h"

namespace homolog {
namespace {

using namespace fixtures;

GridFrame unit_grid(int x, int y, int z) { return {{2 * x + 1, 2 * y + 1, 2 * z + 1}, Vec3(-x, -y, -z), 1}; }

// The strongest response within `reach` of the origin, over the levels of the first octave.
double strongest_near_origin(const Solid& solid, const GridFrame& frame, double reach) {
  double strongest = 0;
  bool first = true;
  for_each_octave(rasterize(solid, frame), {}, [&](const Octave& octave) {
    for (const Volume<float>& level : octave.levels) {
      if (!first) break;
      const GridFrame& f = level.frame;
      for (int k = 0; k < f.size[2]; ++k) {
        for (int j = 0; j < f.size[1]; ++j) {
          for (int i = 0; i < f.size[0]; ++i) {
            if (f.world_from_voxel(Vec3(i, j, k)).cwiseAbs().maxCoeff() < reach) strongest = std::max<double>(strongest, level.at(i, j, k));
          }
        }
      }
    }
    first = false;
  });
  return strongest;
}

TEST(ScaleSpace, BallFormulasHaveThePapersLimits) {
  EXPECT_NEAR(ball_response(1.0001), -std::sqrt(2 / M_PI) * 3 * std::sqrt(3) * std::exp(-1.5), 1e-4);  // -0.925
  EXPECT_NEAR(radius_factor(1.0001), std::sqrt(3), 1e-4);
  const double k = std::cbrt(2);
  EXPECT_NEAR(radius_factor(k), 1.72438, 1e-5);
  for (const double off : {0.97, 1.03}) EXPECT_GT(ball_level(off / radius_factor(k), k), ball_response(k));  // it is the minimum
}

TEST(ScaleSpace, ResponseTellsPlaneSlabCylinderBall) {
  EXPECT_NEAR(strongest_near_origin(box({-30, 0, 0}, {30, 34, 34}), unit_grid(30, 34, 34), 8), 0.26, 0.01);       // half-space x < 0
  EXPECT_NEAR(strongest_near_origin(box({0, 0, 0}, {4, 30, 30}), unit_grid(6, 32, 32), 8), 0.52, 0.01);           // slab
  EXPECT_NEAR(strongest_near_origin(cylinder({-30, 0, 0}, {30, 0, 0}, 5), unit_grid(32, 8, 8), 8), 0.79, 0.015);  // long cylinder
  EXPECT_NEAR(strongest_near_origin(ball({0, 0, 0}, 5), unit_grid(8, 8, 8), 8), 1, 0.03);  // at the nearest level, not the best scale
}

// The same grid centre must have the same scale-normalised value in either octave, however the margins were laid.
TEST(ScaleSpace, OctavesAgreeWhereTheyOverlap) {
  Volume<float> upper;
  bool first = true;
  for_each_octave(rasterize(hand(), 80), {}, [&](const Octave& octave) {
    if (!first && !upper.values.empty()) {
      double worst = 0;
      const GridFrame& f = octave.levels[0].frame;
      EXPECT_NEAR(octave.sigmas[0] * std::cbrt(2), octave.sigmas[1], 1e-12);
      for (int k = 0; k < f.size[2]; ++k) {
        for (int j = 0; j < f.size[1]; ++j) {
          for (int i = 0; i < f.size[0]; ++i) {
            const Vec3 v = upper.frame.voxel_from_world(f.world_from_voxel(Vec3(i, j, k)));
            const int x = static_cast<int>(std::lround(v[0])), y = static_cast<int>(std::lround(v[1])),
                      z = static_cast<int>(std::lround(v[2]));
            ASSERT_LT((v - Vec3(x, y, z)).norm(), 1e-6);  // every coarse voxel is a fine one
            if (upper.frame.contains(x, y, z)) worst = std::max<double>(worst, std::abs(upper.at(x, y, z) - octave.levels[0].at(i, j, k)));
          }
        }
      }
      EXPECT_LT(worst, 3e-3);
    }
    upper = octave.levels[octave.levels.size() - 2];
    first = false;
  });
}

TEST(ScaleSpace, EmptyInteriorHasNoOctaves) {
  Interior nothing{unit_grid(5, 5, 5), std::vector<float>(11 * 11 * 11)};
  for_each_octave(nothing, {}, [](const Octave&) { FAIL(); });
}

}  // namespace
}  // namespace homolog
