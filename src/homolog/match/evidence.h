// SPDX-License-Identifier: MIT
// Beyond the paper: what a refined cloth tells about a match, and how that becomes a confidence. The paper's one-sided chamfer distance
// cannot tell a right map from a flipped one; reach in both directions together with stretch can.
#pragma once

#include "homolog/match/cloth.h"
#include "homolog/match/match.h"

namespace homolog {

/// Shares of the skin samples and edges; all from 0 (bad) to 1 (good) but stretch.
Evidence weigh(const Cloth& cloth, const Body& model, double model_diagonal, const std::vector<SurfaceSample>& data, double data_diagonal);

/// Probability that a match with this evidence is right.
double confidence_of(const Evidence& evidence);

}  // namespace homolog
