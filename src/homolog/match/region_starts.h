// SPDX-License-Identifier: MIT
// Beyond the paper: starts for a model that is a part of the data, whatever its salient points: the similarities that lay principal axes on
// those of regions of the data, settled on the skin.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/growth.h"
#include "homolog/match/regions.h"

namespace homolog {

/// Those of the data that a model, or a region of it, is laid on.
std::vector<Region> regions_to_lay_on(const Body& data);

/// How far the whole model, laid best by its axes on the whole data, is from it, as Settled tells; infinite if either has no skin.
double distance_on_whole(const Shape& model, const Shape& data, Chirality chirality);

/// Up to `most` starts of the given chirality without pairs that lay the axes of the whole model, those that lie best on their regions
/// first; none that lies farther than `farthest`, a share of the size of what it lies on.
std::vector<GrownSet> region_starts(const std::vector<Region>& regions, const Shape& model, Chirality chirality, double farthest,
                                    std::size_t most);

/// The same for regions of the model, which may lie as they are where the rest is bent otherwise: such a start is drawn on to the data from
/// the middle of its region outwards. None that makes the model so large that it is no part of the data.
std::vector<GrownSet> outward_starts(const std::vector<Region>& regions, const Shape& model, const Shape& data, Chirality chirality,
                                     double farthest, std::size_t most);

}  // namespace homolog
