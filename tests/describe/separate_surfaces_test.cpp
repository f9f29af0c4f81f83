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
    for (const int s : surfaces[i]) EXPECT_NEAR((balls.surface[s].position - centres[i]).norm(), radii[i], 0.1);
    count += surfaces[i].size();
  }
  EXPECT_EQ(count, balls.surface.size());
  EXPECT_EQ(separate_surfaces(balls.surface, balls.body, 2).size(), 2u);
}

TEST(SeparateSurfaces, APieceIsAShapeThatKnowsItsPointsInTheWhole) {
  const Shape balls = described(join({ball({0, 0, 0}, 0.5), ball({3, 0, 0}, 1)}));
  const auto surfaces = separate_surfaces(balls.surface, balls.body, 12);
  ASSERT_EQ(surfaces.size(), 2u);
  for (const auto& samples : surfaces) {
    const homolog::Piece piece = piece_of(balls, samples);
    const Shape& shape = piece.shape;
    EXPECT_EQ(shape.surface.size(), samples.size());
    EXPECT_EQ(shape.body.nodes.size(), shape.body.surface_count + shape.points.size());
    EXPECT_EQ(shape.body.edges.first.size(), shape.body.nodes.size() + 1);
    EXPECT_TRUE(shape.body.ways.allFinite());
    ASSERT_EQ(shape.points.size(), piece.points.size());
    for (std::size_t i = 0; i < piece.points.size(); ++i) {
      EXPECT_EQ(shape.points[i].position, balls.points[piece.points[i]].position);
      EXPECT_EQ(shape.body.nodes[shape.body.point_node(i)], shape.points[i].position);
    }
  }
}

TEST(SeparateSurfaces, CrumbsDoNotCount) {
  const Shape balls = described(join({ball({0, 0, 0}, 1), ball({1.3, 0, 0}, 0.06)}));
  EXPECT_TRUE(separate_surfaces(balls.surface, balls.body, 12).empty());
}

}  // namespace
}  // namespace homolog
