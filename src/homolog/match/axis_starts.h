// SPDX-License-Identifier: MIT
// Beyond the paper: starts for whole bodies of the same kind whose salient points differ too much to be paired one by one: the
// similarities that lay the model's principal axes on those of the data and of each of its separate pieces, settled on the skin.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/growth.h"

namespace homolog {

/// Up to `most` starts of the given chirality without pairs on the whole data, best first, and as many on each of its twelve largest
/// pieces (separate_surfaces.h).
std::vector<GrownSet> axis_starts(const Shape& model, const Shape& data, Chirality chirality, std::size_t most);

}  // namespace homolog
