// SPDX-License-Identifier: MIT
// Sec. 6.2.1: pruning of X x X' to the candidate correspondences C-hat.
// Differs: each point keeps its nearest partners by descriptor, both ways, instead of a fixed threshold t_d (which has units);
// only the strongest points are searched from, since plates have hundreds of faint ones.
#pragma once

#include <vector>

#include "homolog/base/parameters.h"
#include "homolog/describe/shape.h"
#include "homolog/match/match.h"

namespace homolog {

/// L1 distance typical of true pairs of free descriptors: the unit in which seeds, growth and guided pairs charge it.
constexpr double descriptor_spread = 3;

/// Candidates ordered by (model, data) index.
CorrespondenceSet find_candidates(const Shape& model, const Shape& data, const Params& params);

}  // namespace homolog
