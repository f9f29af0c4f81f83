// SPDX-License-Identifier: MIT
// Beyond the paper: the ends of a body (of limbs, fingers, tails, wings), the places farther from all others along the inside than
// everything around them. Bending does not move them, and other individuals have them too.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "homolog/describe/body.h"

namespace homolog {

struct Ends {
  std::vector<int> nodes;  ///< of the Body, on its skin, the most prominent first
  Eigen::MatrixXd ways;    ///< lengths of the shortest ways inside, node by end; infinite between separate pieces
};

/// Up to 12 ends whose prominence is at least 6 %: so far, as a share of the longest one, the mean way to the skin falls before it rises
/// to a more prominent end.
Ends find_ends(const Body& body);

}  // namespace homolog
