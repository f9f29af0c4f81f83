// SPDX-License-Identifier: MIT
// Beyond the paper: starts from paired ends of two bodies; every other place follows by its ways to the ends. Limbs in other poses and of
// other lengths find each other so, without a salient point.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/growth.h"

namespace homolog {

/// Up to `most` different starts of the given chirality, without pairs, those that bend space least first; none for fewer than three ends.
std::vector<GrownSet> end_starts(const Shape& model, const Shape& data, Chirality chirality, std::size_t most);

}  // namespace homolog
