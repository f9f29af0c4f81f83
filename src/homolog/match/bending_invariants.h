// SPDX-License-Identifier: MIT
// Beyond the paper: what bending leaves as it is, so that a right map keeps it: the ways inside the body, its thickness and its ends. A
// wrong map can lie close and bend little, but leads across where the data does not.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"

namespace homolog {

/// Mean |log| of the factors by which ways inside the model get longer in the data, over their median; 1 at most, and where nothing is
/// mapped. `laid` is the cloth's mapped skin, `scale` its scale, `extent` as in match.h.
double ways_changed(const std::vector<SurfaceSample>& laid, double scale, const Shape& model, const Shape& data, double extent);

/// As far as thickness is compared, in extents.
constexpr double skin_near = 0.05;

/// The same of the thickness under the skin. `nearest` of the data's samples to the laid ones, at least where it is within skin_near.
double thickness_changed(const std::vector<SurfaceSample>& laid, const std::vector<NearestSample>& nearest, const Shape& model,
                         const Shape& data, double extent);

/// Mean distance from the model's ends to the data's nearest ones, and back from those that the cloth comes near, in extents; .3 at most.
double ends_missed(const Cloth& cloth, const Shape& model, const Shape& data, double extent);

}  // namespace homolog
