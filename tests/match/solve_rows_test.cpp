// SPDX-License-Identifier: MIT
#include "homolog/match/solve_rows.h"

#include <gtest/gtest.h>

#include "match/synthetic_pairs.h"

namespace homolog {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// A ring whose nodes also hold to some farther ones, each to its own place.
Sparse held_graph(int count) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(count, count);
  for (int i = 0; i < count; ++i) {
    for (const int step : {1, 7}) {
      const int j = (i + step) % count;
      if (i != j) dense(i, j) = dense(j, i) = -1;
    }
  }
  for (int i = 0; i < count; ++i) dense(i, i) = 0.01 * (1 + i % 5) - dense.row(i).sum();
  return dense.sparseView();
}

TEST(SolveRows, IsEigensSolutionAndThatOfTheDenseSystem) {
  for (const int count : {1, 2, 50}) {
    const Sparse matrix = held_graph(count), upper = matrix.triangularView<Eigen::Upper>();
    OrderedFactor factor;
    factor.compute(upper);
    PlaceRows rows = PlaceRows::Zero(count, 4);
    const std::vector<Vec3> places = synthetic::points_in_cube(count, 3);
    for (int i = 0; i < count; ++i) rows.row(i).head<3>() = places[i];
    const Eigen::MatrixX3d right = rows.leftCols<3>();
    solve_rows(factor, rows);
    const Eigen::MatrixX3d plain = factor.solve(right), dense = Eigen::MatrixXd(matrix).ldlt().solve(right);
    EXPECT_LT((rows.leftCols<3>() - plain).norm(), 1e-14 * plain.norm());  // nothing, where no compiler fuses Eigen's sums
    EXPECT_LT((rows.leftCols<3>() - dense).norm(), 1e-10 * dense.norm());
    EXPECT_TRUE(rows.col(3).isZero(0));
  }
}

}  // namespace
}  // namespace homolog
