// SPDX-License-Identifier: MIT
#include "homolog/match/energy_increment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "homolog/match/thin_plate_spline.h"
#include "match/synthetic_pairs.h"

namespace homolog {
namespace {

using synthetic::points_in_cube;

std::vector<Vec3> joined(std::vector<Vec3> a, const std::vector<Vec3>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

SmallRows residual(const EnergyIncrement::Block& block, const std::vector<Vec3>& targets) {
  SmallRows rows = -block.predicted;
  for (std::size_t k = 0; k < targets.size(); ++k) rows.row(k) += targets[k].transpose();
  return rows;
}

void expect_equals_fresh_solve(int points, int first, int second) {
  const auto X = points_in_cube(points, 1), Y = points_in_cube(points, 2);
  const auto Xa = points_in_cube(first, 3), Ya = points_in_cube(first, 4), Xb = points_in_cube(second, 5), Yb = points_in_cube(second, 6);
  const EnergyIncrement spline(X, Y);
  const auto a = spline.block(Xa), b = spline.block(Xb);
  const double one = ThinPlateSpline::affine_free(joined(X, Xa), joined(Y, Ya)).energy;
  const double two = ThinPlateSpline::affine_free(joined(joined(X, Xa), Xb), joined(joined(Y, Ya), Yb)).energy;
  EXPECT_NEAR(spline.energy(), ThinPlateSpline::affine_free(X, Y).energy, 1e-7 * two);
  EXPECT_NEAR(spline.energy() + increment(a.precision, residual(a, Ya)), one, 1e-7 * two);
  SmallRows both(first + second, 3);
  both << residual(a, Ya), residual(b, Yb);
  EXPECT_NEAR(spline.energy() + increment(spline.joint_precision(a, b), both), two, 1e-7 * two);
}

TEST(EnergyIncrement, EqualsAFreshSolve) {
  expect_equals_fresh_solve(4, 1, 1);
  expect_equals_fresh_solve(6, 2, 1);
  expect_equals_fresh_solve(8, 1, 2);
  expect_equals_fresh_solve(8, 2, 2);
}

TEST(EnergyIncrement, APointThatIsThereAlreadyHasNoFiniteCost) {
  const auto X = points_in_cube(8, 1);
  const EnergyIncrement spline(X, points_in_cube(8, 2));
  const auto block = spline.block({X[2]});
  EXPECT_EQ(block.precision.size(), 0);
  EXPECT_TRUE(std::isinf(increment(block.precision, residual(block, {Vec3::Zero()}))));
}

TEST(EnergyIncrement, SourcesInAPlaneHaveInfiniteEnergy) {
  auto X = points_in_cube(6, 1);
  for (Vec3& x : X) x.z() = 0.5;
  EXPECT_TRUE(std::isinf(EnergyIncrement(X, points_in_cube(6, 2)).energy()));
}

}  // namespace
}  // namespace homolog
