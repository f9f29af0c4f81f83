// SPDX-License-Identifier: MIT
// The ends of a body are where its limbs end, whatever its place, size and grid.
#include "homolog/describe/ends.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fixtures/shapes.h"

namespace homolog {
namespace {

using namespace fixtures;

double distance_to_nearest_end(const Shape& shape, const Vec3& place) {
  double least = 1e300;
  for (const int node : shape.ends.nodes) least = std::min(least, (shape.body.nodes[node] - place).norm());
  return least;
}

const std::vector<Vec3> fingertips = {{0.62, 0.2, 0.3}, {0.38, 0.82, 0.1}, {0.11, 1.02, 0.06}, {-0.19, 0.9, 0.12}, {-0.48, 0.62, 0.16}};

TEST(Ends, AHandEndsInFiveFingersAndTheWrist) {
  const Shape shape = described(hand());
  EXPECT_EQ(shape.ends.nodes.size(), 6u);
  for (const Vec3& tip : fingertips) EXPECT_LT(distance_to_nearest_end(shape, tip), 0.15) << tip.transpose();  // finger radii to .1
  EXPECT_LT(distance_to_nearest_end(shape, {0.03, -0.75, -0.05}), 0.3);                                        // the wrist's is .2
}

TEST(Ends, AQuadrupedEndsInFeetHeadAndTail) {
  const Shape shape = described(quadruped());
  for (const double side : {-0.17, 0.17}) {
    for (const double x : {0.43, -0.48}) EXPECT_LT(distance_to_nearest_end(shape, {x, side, -0.82}), 0.15);
  }
  EXPECT_LT(distance_to_nearest_end(shape, {1.1, 0, 0.5}), 0.2);
  EXPECT_LT(distance_to_nearest_end(shape, {-0.98, 0, -0.12}), 0.15);
}

TEST(Ends, StayWhenTheBodyIsMoved) {
  const fixtures::Similarity move{random_rotation(4), 30, {5, -70, 9}};
  const Shape shape = described(moved(hand(), move));
  EXPECT_EQ(shape.ends.nodes.size(), 6u);
  for (const Vec3& tip : fingertips) EXPECT_LT(distance_to_nearest_end(shape, move(tip)), 30 * 0.15);
}

TEST(Ends, WaysAreThoseInsideTheBody) {
  const Shape shape = described(hand());
  for (std::size_t k = 0; k < shape.ends.nodes.size(); ++k) {
    const std::vector<double> ways = shortest_ways(shape.body, {shape.ends.nodes[k]});
    for (std::size_t node = 0; node < ways.size(); ++node) EXPECT_NEAR(shape.ends.ways(node, k), ways[node], 1e-12);
  }
}

TEST(Ends, NothingHasNone) { EXPECT_TRUE(find_ends({}).nodes.empty()); }

}  // namespace
}  // namespace homolog
