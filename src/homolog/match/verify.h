// SPDX-License-Identifier: MIT
// Sec. 6.2.3: the paper's verification of grown sets: bending (eq. 8) and chamfer distance (eq. 9), largest set first.
#pragma once

#include "homolog/base/parameters.h"
#include "homolog/describe/shape.h"
#include "homolog/match/match.h"

namespace homolog {

/// Fills in the chamfer distance of every match (eq. 9), over the model's inside near the matched points.
void measure_chamfer(std::vector<Match>& matches, const Shape& model, const Shape& data);

/// The sets that are correct by eq. 8 and 9, by falling number of pairs, warped by the paper's spline. They carry no confidence but the
/// share of model points that they match.
std::vector<Match> verified_sets(const std::vector<CorrespondenceSet>& sets, const Shape& model, const Shape& data, const Params& params,
                                 bool without_identity);

}  // namespace homolog
