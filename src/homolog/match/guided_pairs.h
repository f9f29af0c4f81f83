// SPDX-License-Identifier: MIT
// Beyond the paper: all salient points predicted by the refined map; what it contradicts leaves the set, what it explains joins.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"
#include "homolog/match/match.h"

namespace homolog {

/// One-to-one pairs within .6 r' and .35 in log r of the prediction, ordered by model index; `confidence` is how well each fits, 0 to 1.
/// `widening` >= 1 stretches the first limit, and its root the second, while the map is still rough.
CorrespondenceSet guided_pairs(const Cloth& cloth, const Shape& model, const Shape& data, DescriptorKind kind, double widening);

}  // namespace homolog
