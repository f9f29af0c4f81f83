// SPDX-License-Identifier: MIT
// Sec. 6 and 6.2.3: from grown sets to the family: refined, weighed, without duplicates, best first, handedness told.
// Differs: ranked by the dense evidence of both shapes instead of the number of pairs (docs/paper_map.md).
#pragma once

#include "homolog/base/parameters.h"
#include "homolog/base/stopwatch.h"
#include "homolog/describe/shape.h"
#include "homolog/match/growth.h"
#include "homolog/match/match.h"

namespace homolog {

/// The best sets, best first, that share at most half of their pairs with a better one of the same chirality and lay the model's points
/// elsewhere.
std::vector<GrownSet> distinct_sets(std::vector<GrownSet> sets, std::size_t most, const Shape& model);

/// Whether --mirror lets a match of this chirality be told.
bool allowed(Chirality chirality, Mirror mirror);

/// `sets` refined and ranked. `without_identity`: leave out what maps a shape on itself as it is.
Family make_family(const std::vector<GrownSet>& sets, const Shape& model, const Shape& data, const Params& params, bool without_identity,
                   Stopwatch* watch = nullptr);

}  // namespace homolog
