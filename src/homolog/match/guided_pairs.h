// SPDX-License-Identifier: MIT
// Beyond the paper: all salient points predicted by the refined map; what it contradicts leaves the set, what it explains joins.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"
#include "homolog/match/match.h"

namespace homolog {

/// How far a data point may be from its prediction.
struct PairLimits {
  double place = 0.6;  ///< in r'
  double log_radius = 0.35;
  double least_place = 0;  ///< in the data's units: no place nearer is too far, for small points are missed by more radii
};

/// One-to-one pairs within the limits, ordered by model index; `confidence` is how well each fits, 0 to 1.
CorrespondenceSet guided_pairs(const Cloth& cloth, const Shape& model, const Shape& data, DescriptorKind kind, const PairLimits& limits);

}  // namespace homolog
