// SPDX-License-Identifier: MIT
// A factored sparse system solved for the coordinates of places together: Eigen runs through the factor once for each of them.
#pragma once

#include <Eigen/Sparse>

namespace homolog {

/// L D L' of a symmetric matrix that is given by its upper half, eliminated in the order of its rows.
using OrderedFactor = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper, Eigen::NaturalOrdering<int>>;

/// Places as rows, the fourth column being free, so that a row is a whole vector.
using PlaceRows = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// Right sides become solutions, by the sums of OrderedFactor::solve() in the same order.
void solve_rows(const OrderedFactor& factor, PlaceRows& rows);

}  // namespace homolog
