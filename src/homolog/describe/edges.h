// SPDX-License-Identifier: MIT
// Beyond the paper: what of a body's edges never changes, however it is bent and laid.
#pragma once

#include <vector>

#include "homolog/base/vec.h"

namespace homolog {

/// At rest, node after node.
struct Edges {
  std::vector<int> first, other;
  std::vector<Vec3> vector;      ///< from the node to the other one
  std::vector<Vec3> sum;         ///< of these, per node
  std::vector<double> square;    ///< sum of squared lengths, per node
  std::vector<Mat3> inverse;     ///< of the sum of outer squares, made regular
  std::vector<int> elimination;  ///< nodes in an order in which a system along the edges is solved with little fill
};

/// Share of the squared edges that is added across every neighbourhood, so that a flat one is regular.
constexpr double flat_share = 0.05;

Edges edges_of(const std::vector<Vec3>& nodes, const std::vector<std::vector<int>>& neighbours);

}  // namespace homolog
