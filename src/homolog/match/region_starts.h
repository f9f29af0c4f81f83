// SPDX-License-Identifier: MIT
// Beyond the paper: starts for a model that is a part of the data, whatever its salient points: the similarities that lay its principal
// axes on those of regions of the data, settled on the skin. A region is what lies within a way inside from a place on the data's skin.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/growth.h"
#include "homolog/match/settled_skins.h"

namespace homolog {

std::vector<AxisSkin> regions_of(const Body& data);

/// Up to `most` starts of the given chirality without pairs, those that lie best on their regions first; none that lies worse than the
/// model on the whole data, each as a share of the size of what it lies on.
std::vector<GrownSet> region_starts(const std::vector<AxisSkin>& regions, const Shape& model, const Shape& data, Chirality chirality,
                                    std::size_t most);

}  // namespace homolog
