// SPDX-License-Identifier: MIT
// Beyond the paper: salient points of the model followed into the data by the map. Along a limb or over a plate the scale space is nearly
// even, so its minima lie at other places in every individual; the place that corresponds is there all the same.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"
#include "homolog/match/match.h"

namespace homolog {

/// A pair for every model point that has none among the `rated` ones: its data point is where the cloth lays it, as large as the cloth
/// makes it, and has no place in Shape::points yet. `confidence` is the probability that the place is right, logistic in the merit of the
/// match, the point's response, how far the next trusted pair is along the inside (in `extent`s), and how the skin around comes to lie:
/// bent, of other thickness, or not on the data's; fitted to the first four matches of 476 real pairs of shapes.
CorrespondenceSet followed_pairs(const CorrespondenceSet& rated, const Cloth& cloth, double merit, double extent, const Shape& model,
                                 const Shape& data);

/// Measures what followed pairs (data < 0) lack: direction and response of the data point there, and the descriptors' distance.
void describe_followed(CorrespondenceSet& pairs, const Shape& model, const Shape& data, const Params& params);

}  // namespace homolog
