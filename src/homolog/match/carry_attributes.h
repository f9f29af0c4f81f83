// SPDX-License-Identifier: MIT
// Beyond the paper: what is painted on one shape, carried to the vertices of the other by a dense map.
#pragma once

#include <optional>
#include <vector>

#include "homolog/match/dense.h"
#include "homolog/shape/attributes.h"

namespace homolog {

/// The colours and fields of `giver` at the receiver's vertices, whose places on giver.mesh are `places`, its texturing
/// (carry_texturing.h), and its rig, shape keys and animations by a map of that chirality (carry_rig.h, carry_animations.h). Between the
/// corners of a triangle colours and values are shared out by barycentric coordinates, and a label is the one with the largest share, so
/// none comes up that was not there. A vertex without a place, or where most of the triangle has no value, has none: NaN, and the colour
/// no_colour.
AttributedMesh carry_attributes(const AttributedMesh& giver, const Mesh& receiver, const std::vector<DensePlace>& places,
                                Chirality chirality = Chirality::proper);

inline constexpr Rgba no_colour = {128 / 255.0f, 128 / 255.0f, 128 / 255.0f, 1};

/// The value at a place of a triangle whose corners have these, NaN for none.
double value_between(const std::array<double, 3>& values, const Vec3& barycentric);

/// The label there: the first of those with the largest share; NaN if that is none.
double label_between(const std::array<double, 3>& labels, const Vec3& barycentric);

}  // namespace homolog
