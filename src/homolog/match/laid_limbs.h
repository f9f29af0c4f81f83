// SPDX-License-Identifier: MIT
// Beyond the paper: limbs laid along others at their full length. A cloth draws its limbs to their own length, so what is longer in the
// data is left behind at its tip; where ends of both bodies belong together, the limb's length there becomes the length at rest.
#pragma once

#include <cstddef>
#include <vector>

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"
#include "homolog/match/limbs.h"

namespace homolog {

/// Lays the limbs of the model that end in the chosen ones of the ends together along the data's, evenly from where they branch off to
/// the tip, each with its own thickness, and stretches their rest by as much. Leaves a limb without a length as it is.
void lay_limbs(Cloth& cloth, const EndsTogether& together, const std::vector<std::size_t>& chosen, const Shape& model, const Shape& data);

/// Lays those that are longer or shorter in the data by a tenth and end more than .03 of the matched extent from there. Out: their ends at
/// the data's, as anchors that keep them there; none if there are none.
std::vector<Anchor> lay_limbs_of_other_length(Cloth& cloth, const Shape& model, const Shape& data);

}  // namespace homolog
