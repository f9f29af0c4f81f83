// SPDX-License-Identifier: MIT
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"
#include "homolog/match/limbs.h"
#include "homolog/match/match.h"

namespace homolog {

/// The model points of pairs at their data points.
std::vector<Anchor> anchors_of(const CorrespondenceSet& pairs, const Body& model);

/// draw_cloth() of a laid model by the data's surface near it, `most` samples of it, and by anchors; along the limbs of ends that belong
/// together (limbs.h).
void draw_onto(Cloth& cloth, const Shape& model, const Shape& data, const std::vector<Anchor>& anchors, const ClothSchedule& schedule,
               std::size_t most, const EndsTogether& ends = {});

}  // namespace homolog
