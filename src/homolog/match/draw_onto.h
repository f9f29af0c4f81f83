// SPDX-License-Identifier: MIT
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"
#include "homolog/match/limbs.h"
#include "homolog/match/match.h"

namespace homolog {

/// draw_cloth() of a laid model by the data's surface near it, `most` samples of it, and by the data points of pairs; along the limbs of
/// ends that belong together (limbs.h).
void draw_onto(Cloth& cloth, const Shape& model, const Shape& data, const CorrespondenceSet& pairs, const ClothSchedule& schedule,
               std::size_t most, const EndsTogether& ends = {});

}  // namespace homolog
