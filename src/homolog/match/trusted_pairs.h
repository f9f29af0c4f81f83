// SPDX-License-Identifier: MIT
// Beyond the paper: how likely each pair of a refined match is right, and the pairs that deserve to be told.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"
#include "homolog/match/match.h"

namespace homolog {

/// The pairs with their `confidence` set: the probability that the pair is right, logistic in the merit of the match, in how far the map
/// misses the data point (as a share of `extent`), and in how many rivals have more similar descriptors; fitted to the pairs of the first
/// four matches of 476 real pairs of shapes. Those below 0.75 are left out, but never the best five.
CorrespondenceSet trusted_pairs(CorrespondenceSet pairs, const Cloth& cloth, double merit, double extent, const Shape& model,
                                const Shape& data, DescriptorKind kind);

}  // namespace homolog
