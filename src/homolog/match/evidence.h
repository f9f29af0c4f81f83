// SPDX-License-Identifier: MIT
// Beyond the paper: what a refined cloth tells about a match, and how that becomes a confidence. The paper's one-sided chamfer distance
// cannot tell a right map from a flipped one; reach in both directions together with the bending of the body can.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"
#include "homolog/match/match.h"

namespace homolog {

/// So near, in matched extents along the normal, two skins are one.
constexpr double reached_share = 0.02;

/// The matched extent of the cloth's shapes (match.h).
double extent_of(const Cloth& cloth, const Shape& model, const Shape& data);

/// Mean angle, in radians, between the rotations of a node and of its neighbours.
double turning_at(const Cloth& cloth, const Body& model, int node);

/// All but Evidence::support, which needs the pairs (refine.cpp).
Evidence weigh(const Cloth& cloth, const Shape& model, const Shape& data);

/// Evidence::model_reached of a cloth, alone.
double model_reached(const Cloth& cloth, const Shape& model, const Shape& data);

/// Share of the data's skin on which the model comes to lie.
double data_reached(const Cloth& cloth, const Shape& model, const Shape& data);

/// One number that orders the matches of a pair of shapes: reach both ways and a little for every salient point paired, less what bending
/// alone would not change, and less bending. Weights by conditional logistic regression within 476 pairs of real shapes.
double merit_of(const Evidence& evidence);

/// What the family is ordered by: the merit, less a handicap for mirrored matches, which are rarely meant.
double rank_merit(const Evidence& evidence, Chirality chirality);

/// Probability that the best match of a pair is right, logistic in its rank merit, so that it falls along a family, and in the logarithm
/// of `ways`: in how many ways the same part can be laid about as well, this one and its mirror image counted, at least 1. Slopes fitted to
/// the first places of 589 related pairs of real shapes and 162 that share nothing, the odds raised since for what is told better
/// (docs/accuracy.md).
double confidence_of(const Evidence& evidence, Chirality chirality, double ways);

}  // namespace homolog
