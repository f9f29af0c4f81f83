// SPDX-License-Identifier: MIT
// Beyond the paper: starts from paired ends of two bodies; every other place follows by its ways to the ends. Limbs in other poses and of
// other lengths find each other so, without a salient point.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/growth.h"

namespace homolog {

/// Places of the model and where they follow a set of paired ends to, whatever the chirality: the ends themselves, and middles of limbs.
struct FollowedEnds {
  SourceSystem model;
  std::vector<Vec3> data;
};

/// One for each set of paired ends; none for fewer than three ends.
std::vector<FollowedEnds> follow_ends(const Shape& model, const Shape& data);

/// Up to `most` different starts of the given chirality, without pairs, those that bend space least first.
std::vector<GrownSet> end_starts(const std::vector<FollowedEnds>& followed, const Shape& model, const Shape& data, Chirality chirality,
                                 std::size_t most);

}  // namespace homolog
