// SPDX-License-Identifier: MIT
// Beyond the paper: how likely each pair of a refined match is right, and the pairs that deserve to be told.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"
#include "homolog/match/match.h"

namespace homolog {

/// Sets their `confidence`: the probability that a pair is right, logistic in the merit of the match, in how far the map misses the data
/// point (as a share of `extent`), and in how many rivals have more similar descriptors; fitted to the pairs of the first four matches of
/// 476 real pairs of shapes.
void rate_pairs(CorrespondenceSet& pairs, const Cloth& cloth, double merit, double extent, const Shape& model, const Shape& data,
                DescriptorKind kind);

/// Those that are right with a probability of 0.75 at least, as rated before the way back.
CorrespondenceSet trusted_pairs(CorrespondenceSet rated);

/// Of rated pairs and followed ones (followed_points.h) those that are right with a probability of 0.83 at least, and the best others where
/// they are not seven. Ordered by model index; a followed place within half a radius of a surer one is left out.
CorrespondenceSet told_pairs(CorrespondenceSet rated, const CorrespondenceSet& followed);

}  // namespace homolog
