// SPDX-License-Identifier: MIT
// The body graph: ways run inside, so that distances do not change when a body bends and limbs that stand close stay apart.
#include "homolog/describe/body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fixtures/solids.h"

namespace homolog {
namespace {

using namespace fixtures;

struct Case {
  Interior interior;
  Body body;
  Eigen::MatrixXd distances;
};

Case case_of(const Solid& solid, const std::vector<Vec3>& places, std::size_t samples = 400) {
  std::vector<SalientPoint> points;
  for (const Vec3& place : places) points.push_back({place, 0.1});
  Case c{rasterize(solid, 64), {}, {}};
  c.body = build_body(c.interior, sample_surface(c.interior, 800), samples, points);
  c.distances = inner_distances(c.body, c.interior);
  return c;
}

// Two legs of radius 0.1 that stand half a radius apart, joined at their feet.
constexpr double apart = 0.25;
Solid u_shape() {
  return join({capsule({0, 0, 0}, {0, 1, 0}, 0.1), capsule({apart, 0, 0}, {apart, 1, 0}, 0.1), capsule({0, 0, 0}, {apart, 0, 0}, 0.1)});
}

TEST(Body, FromTipToTipOfAUTheWayIsTheUNotTheGap) {
  const Case c = case_of(u_shape(), {{0, 1, 0}, {apart, 1, 0}});
  const double least = 2 * std::hypot(0.1, 0.9) + apart - 0.2;  // around the inner corners
  EXPECT_GT(c.distances(0, 1), 0.98 * least);
  EXPECT_LT(c.distances(0, 1), 1.1 * (2 + apart));  // along the middle line, over nodes that lie to its sides
}

TEST(Body, LegsThatStandCloseAreNotJoined) {
  const Case c = case_of(u_shape(), {});
  const double middle = 0.5 * apart;
  for (std::size_t i = 0; i < c.body.nodes.size(); ++i) {
    for (const int j : c.body.neighbours[i]) {
      const Vec3 &a = c.body.nodes[i], &b = c.body.nodes[j];
      const bool across = (a.x() - middle) * (b.x() - middle) < 0 && std::min(a.y(), b.y()) > 0.15;  // above the joint at y < 0.1
      EXPECT_FALSE(across) << a.transpose() << " to " << b.transpose();
    }
  }
}

// As long as the limb is less than two samples thick: nearer nodes on the same side come first, ten in all.
TEST(Body, OppositeSidesOfAThinLimbAreJoined) {
  const Case c = case_of(capsule({0, 0, 0}, {1, 0, 0}, 0.08), {}, 60);  // samples are 0.09 apart
  int across = 0;
  for (std::size_t i = 0; i < c.body.nodes.size(); ++i) {
    for (const int j : c.body.neighbours[i]) across += c.body.normals[i].dot(c.body.normals[j]) < -0.5;
  }
  EXPECT_GT(across, static_cast<int>(c.body.nodes.size()) / 4);
}

TEST(Body, NeighboursAreSymmetricAndInOrder) {
  const Case c = case_of(hand(), {{0, 0, 0}, {0.11, 1.0, 0.06}});
  for (int i = 0; i < static_cast<int>(c.body.nodes.size()); ++i) {
    const auto& list = c.body.neighbours[i];
    EXPECT_FALSE(list.empty());
    EXPECT_TRUE(std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) == list.end());  // rising, each once
    for (const int j : list) {
      EXPECT_NE(i, j);
      EXPECT_TRUE(std::binary_search(c.body.neighbours[j].begin(), c.body.neighbours[j].end(), i));
    }
  }
}

TEST(Body, StraightWaysInsideAreExact) {
  const Case c = case_of(capsule({0, 0, 0}, {1, 0.5, 0.2}, 0.15), {{0, 0, 0}, {1, 0.5, 0.2}, {0.4, 0.2, 0.1}});
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      EXPECT_NEAR(c.distances(i, j), (c.body.nodes[c.body.point_node(i)] - c.body.nodes[c.body.point_node(j)]).norm(), 1e-12);
    }
  }
}

TEST(Body, BendingAnElbowHardlyChangesTheWay) {
  const Vec3 elbow(1, 0, 0);
  const double straight = 2;
  for (const double angle : {0.5, 1.0, 1.5}) {
    const Vec3 hand_place = elbow + Vec3(std::cos(angle), std::sin(angle), 0);
    const Case c = case_of(join({capsule({0, 0, 0}, elbow, 0.12), capsule(elbow, hand_place, 0.12)}), {{0, 0, 0}, hand_place});
    EXPECT_NEAR(c.distances(0, 1), straight, 0.12 * straight) << angle;  // ways run zigzag over nodes; seeds forgive 20 %
    EXPECT_NEAR(c.distances(0, 1), c.distances(1, 0), 1e-12);
  }
}

TEST(Body, SeparatePiecesAreInfinitelyFar) {
  const Case c = case_of(join({ball({0, 0, 0}, 0.3), ball({1, 0, 0}, 0.3)}), {{0, 0, 0}, {1, 0, 0}, {0.1, 0, 0}});
  EXPECT_TRUE(std::isinf(c.distances(0, 1)));
  EXPECT_NEAR(c.distances(0, 2), 0.1, 1e-12);
}

TEST(Body, SpacingIsThatOfTheSkin) {
  const Case c = case_of(ball({0, 0, 0}, 1), {});
  const double even = std::sqrt(4 * M_PI / 400);  // side of the square that each of 400 samples has to itself
  EXPECT_NEAR(c.body.spacing, even, 0.25 * even);
}

}  // namespace
}  // namespace homolog
