// SPDX-License-Identifier: MIT
// Sec. 6.2.1, App. A and B, done differently: seeds are pairs of candidates that agree on one scale, with a third one that fixes the frame.
// Differs: the paper's quadruples need six agreements at once and hardly survive bending (quadruples.h keeps them selectable); distances
// are compared straight and along the body, by logarithm, so that neither size nor pose matters.
#pragma once

#include <vector>

#include "homolog/describe/shape.h"
#include "homolog/match/match.h"

namespace homolog {

struct Seed {
  CorrespondenceSet pairs;
  double cost = 0;  ///< smaller is better
};

/// The most promising seeds, best first, each candidate in few of them.
std::vector<Seed> find_seeds(const CorrespondenceSet& candidates, const Shape& model, const Shape& data);

}  // namespace homolog
