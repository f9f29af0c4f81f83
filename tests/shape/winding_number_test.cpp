// SPDX-License-Identifier: MIT
#include "homolog/shape/winding_number.h"

#include <gtest/gtest.h>

#include "shape/meshes.h"

namespace homolog {
namespace {

constexpr double precision = 0.05;

TEST(WindingNumber, IsWholeForClosedSurfaces) {
  const Mesh torus = meshes::torus(1, 0.3, 60, 30), twice = meshes::joined(torus, torus);
  const WindingNumber once(torus.vertices, torus.triangles), doubled(twice.vertices, twice.triangles);
  for (double angle = 0; angle < 6; angle += 0.1) {
    const Vec3 outward(std::cos(angle), std::sin(angle), 0);
    for (const auto& [distance, turns] : {std::pair{0.0, 0}, {0.65, 0}, {0.72, 1}, {1.0, 1}, {1.28, 1}, {1.33, 0}, {9.0, 0}}) {
      EXPECT_NEAR(once.at(distance * outward), turns, precision) << angle << " " << distance;
      EXPECT_NEAR(doubled.at(distance * outward), 2 * turns, 2 * precision);
    }
  }
}

TEST(WindingNumber, IsTheSolidAngleOfAnOpenSurface) {
  Mesh half = meshes::sphere(4);
  std::erase_if(half.triangles,
                [&](const auto& t) { return half.vertices[t[0]].z() + half.vertices[t[1]].z() + half.vertices[t[2]].z() < 0; });
  const WindingNumber winding(half.vertices, half.triangles);
  EXPECT_NEAR(winding.at(Vec3::Zero()), 0.5, precision);
  const double height = 2;  // from below, a hemisphere fills the solid angle of its rim, seen from behind
  EXPECT_NEAR(winding.at({0, 0, -height}), (1 - height / std::sqrt(height * height + 1)) / 2, precision);
  EXPECT_NEAR(winding.at({0, 0, 100}), 0, 1e-4);
}

TEST(WindingNumber, LooksAtFewGroupsFromFarAway) {
  const Mesh ball = meshes::sphere(4);
  const WindingNumber winding(ball.vertices, ball.triangles);
  EXPECT_EQ(winding.looked_at({100, 0, 0}), 1u);
  EXPECT_GT(winding.looked_at({1, 0, 0}), 20u);
  EXPECT_LT(winding.looked_at({1, 0, 0}), ball.triangles.size());
}

TEST(WindingNumber, OfNothingIsNothing) { EXPECT_EQ(WindingNumber({}, {}).at({1, 2, 3}), 0); }

}  // namespace
}  // namespace homolog
