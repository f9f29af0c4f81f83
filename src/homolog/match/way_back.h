// SPDX-License-Identifier: MIT
// Beyond the paper: the data laid back onto the model. A pair whose data point does not come home is doubted: the two maps see the same
// two surfaces, but with the stiffness of different bodies, so that they err in different places.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"
#include "homolog/match/match.h"

namespace homolog {

/// From the data to the model: the inverse of the cloth's map, drawn anew onto the model by the surfaces alone, since pairs would have it
/// repeat what they got wrong.
ThinPlateSpline way_back(const Cloth& cloth, const Shape& model, const Shape& data);

/// Corrects the confidence of rated pairs by how far from its model point a data point comes home, as a share of `extent` (in the model);
/// fitted to the pairs of the first four matches of 476 real pairs of shapes.
void rate_by_way_back(CorrespondenceSet& pairs, const ThinPlateSpline& model_from_data, double extent);

}  // namespace homolog
