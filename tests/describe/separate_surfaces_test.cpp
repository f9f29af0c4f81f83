// SPDX-License-Identifier: MIT
#include "homolog/describe/separate_surfaces.h"

#include <gtest/gtest.h>

#include "fixtures/shapes.h"

namespace homolog {
namespace {

using namespace fixtures;

TEST(SeparateSurfaces, OneShapeHasNone) {
  const Shape& hand = described_hand();
  EXPECT_TRUE(separate_surfaces(hand.surface, hand.body, 12).empty());
}

TEST(SeparateSurfaces, EachBallKeepsItsSamplesTheLargestFirst) {
  const Shape balls = described(join({ball({0, 0, 0}, 0.5), ball({3, 0, 0}, 1), ball({-2, 0, 0}, 0.7)}));
  const auto surfaces = separate_surfaces(balls.surface, balls.body, 12);
  ASSERT_EQ(surfaces.size(), 3u);
  const Vec3 centres[] = {{3, 0, 0}, {-2, 0, 0}, {0, 0, 0}};
  const double radii[] = {1, 0.7, 0.5};
  std::size_t count = 0;
  for (int i = 0; i < 3; ++i) {
    for (const SurfaceSample& s : surfaces[i]) EXPECT_NEAR((s.position - centres[i]).norm(), radii[i], 0.1);
    count += surfaces[i].size();
  }
  EXPECT_EQ(count, balls.surface.size());
  EXPECT_EQ(separate_surfaces(balls.surface, balls.body, 2).size(), 2u);
}

TEST(SeparateSurfaces, CrumbsDoNotCount) {
  const Shape balls = described(join({ball({0, 0, 0}, 1), ball({1.3, 0, 0}, 0.06)}));
  EXPECT_TRUE(separate_surfaces(balls.surface, balls.body, 12).empty());
}

}  // namespace
}  // namespace homolog
