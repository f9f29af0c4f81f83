// SPDX-License-Identifier: MIT
// Systems along the edges are eliminated in another order, to the same solution.
#include "homolog/describe/edges.h"

#include <gtest/gtest.h>

#include <Eigen/Sparse>
#include <numeric>

#include "match/synthetic_pairs.h"

namespace homolog {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Factor = Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>>;

/// Points joined where they lie near.
std::vector<std::vector<int>> near_ones(const std::vector<Vec3>& nodes, double reach) {
  std::vector<std::vector<int>> neighbours(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      if (i != j && (nodes[i] - nodes[j]).norm() < reach) neighbours[i].push_back(static_cast<int>(j));
    }
  }
  return neighbours;
}

/// Laplacian and 1, rows and columns in an order.
Eigen::MatrixXd system_of(const std::vector<std::vector<int>>& neighbours, const std::vector<int>& order) {
  const auto n = static_cast<Eigen::Index>(neighbours.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
  for (int i = 0; i < n; ++i) {
    for (const int j : neighbours[i]) matrix(i, i) += 1, matrix(i, j) -= 1;
  }
  return matrix(order, order);
}

TEST(Edges, AreEliminatedWithLessFillToTheSameSolution) {
  const std::vector<Vec3> nodes = synthetic::points_in_cube(300, 2);
  const auto neighbours = near_ones(nodes, 0.2);
  const std::vector<int> order = edges_of(nodes, neighbours).elimination;
  std::vector<int> as_they_come(nodes.size()), sorted = order;
  std::iota(as_they_come.begin(), as_they_come.end(), 0);
  std::sort(sorted.begin(), sorted.end());
  ASSERT_EQ(sorted, as_they_come);
  const Eigen::MatrixXd dense = system_of(neighbours, as_they_come);
  const Factor ordered(system_of(neighbours, order).sparseView()), plain(dense.sparseView());
  EXPECT_LT(ordered.matrixL().nestedExpression().nonZeros(), plain.matrixL().nestedExpression().nonZeros());
  Eigen::VectorXd right(dense.rows());
  for (Eigen::Index i = 0; i < right.size(); ++i) right[i] = nodes[static_cast<std::size_t>(i)].x();
  const Eigen::VectorXd solution = ordered.solve(right(order)), expected = dense.ldlt().solve(right)(order);
  EXPECT_LT((solution - expected).norm(), 1e-12 * expected.norm());
}

}  // namespace
}  // namespace homolog
