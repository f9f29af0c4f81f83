// SPDX-License-Identifier: MIT
// Beyond the paper: the data laid back onto the model. A pair whose data point does not come home is doubted: the two maps see the same
// two surfaces, but with the stiffness of different bodies, so that they err in different places.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"
#include "homolog/match/match.h"
#include "homolog/shape/nearest_points.h"

namespace homolog {

/// The data's body in the model: laid there by the inverse of the cloth's map, and drawn anew by the surfaces alone, since pairs would have
/// it repeat what they got wrong.
Cloth laid_back(const Cloth& cloth, const Shape& model, const Shape& data);

/// Where a place of a body lies with its laid cloth, by the frames of the nearest nodes; `near` asks the body's nodes.
Vec3 place_in(const Cloth& cloth, const Body& body, const NearestPoints& near, const Vec3& x);

/// Corrects the confidence of rated pairs by how far from its model point a data point comes home, as a share of `extent` (in the model);
/// fitted to the pairs of the first four matches of 476 real pairs of shapes, and raised since, when maps had become better
/// (docs/accuracy.md).
void rate_by_way_back(CorrespondenceSet& pairs, const Cloth& back, const Body& data, double extent);

}  // namespace homolog
