// SPDX-License-Identifier: MIT
// Beyond the paper: how the body turns and stretches about each of its nodes, from where the nodes' neighbours lie.
#pragma once

#include <vector>

#include "homolog/match/cloth.h"

namespace homolog {

/// A body's edges at rest, node after node, and what of them never changes.
struct Edges {
  std::vector<int> first, other;
  std::vector<Vec3> vector;    ///< from the node to the other one
  std::vector<double> square;  ///< sum of squared lengths, per node
  std::vector<Mat3> inverse;   ///< of the sum of outer squares, made regular
};

Edges edges_of(const Body& model);

/// Best local rotations, and local scales and stretches half way between the measured ones and the cloth's scale: a limb may become
/// longer without becoming thicker.
void fit_local_frames(Cloth& cloth, const Edges& edges);

}  // namespace homolog
