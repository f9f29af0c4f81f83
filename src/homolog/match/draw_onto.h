// SPDX-License-Identifier: MIT
// A laid model drawn onto the data near it.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"
#include "homolog/match/limbs.h"
#include "homolog/match/match.h"

namespace homolog {

/// How a cloth is first laid from the places of its start, and how it is laid in the end, in matched extents.
constexpr ClothSchedule first_draw(int steps) { return {steps, 0.06, 0.015, 2, 0.2}; }
constexpr ClothSchedule last_draw(int steps) { return {steps, 0.03, 0.008, 0.7, 0.1}; }

/// The model points of pairs at their data points.
std::vector<Anchor> anchors_of(const CorrespondenceSet& pairs, const Body& model);

/// draw_cloth() of a laid model by the data's surface near it, `most` samples of it, and by anchors; along the limbs of ends that belong
/// together (limbs.h).
void draw_onto(Cloth& cloth, const Shape& model, const Shape& data, const std::vector<Anchor>& anchors, const ClothSchedule& schedule,
               std::size_t most, const EndsTogether& ends = {});

}  // namespace homolog
