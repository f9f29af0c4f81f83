// SPDX-License-Identifier: MIT
// Beyond the paper: a grown set laid as a cloth, its pairs guided by the refined map, and the map told as a spline.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"
#include "homolog/match/growth.h"
#include "homolog/match/match.h"

namespace homolog {

struct RefinedMatch {
  Match match;
  Cloth cloth;
};

/// Two rounds of cloth and guided pairs. The match has its evidence and confidence; handedness is the chirality of its map.
RefinedMatch refine_set(const GrownSet& set, const Shape& model, const Shape& data, const Params& params);

}  // namespace homolog
