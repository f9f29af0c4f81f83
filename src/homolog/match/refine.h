// SPDX-License-Identifier: MIT
// Beyond the paper: a grown set laid as a cloth, its pairs guided by the refined map, and the map told as a spline.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"
#include "homolog/match/growth.h"
#include "homolog/match/match.h"

namespace homolog {

/// A match on its way: its pairs so far, its cloth, and what the cloth tells.
struct Refined {
  CorrespondenceSet pairs;  ///< all that the cloth explains, rated in the end
  Cloth cloth;
  Evidence evidence;
  double confidence = 0;  ///< left to the family
};

/// Steps of the first draw.
inline constexpr int first_steps = 12;

/// Lays the set by its spline, and draws it outwards if it says from where.
Refined lay_set(const GrownSet& set, const Shape& model, const Shape& data);

/// Draws it on to the data by some of the first steps, from `begin` up to `end`, and weighs it.
void draw_set(Refined& refined, const Shape& model, const Shape& data, DescriptorKind kind, int begin, int end);

/// Rounds of pairs guided by the cloth and of drawing with them.
void guide_pairs(Refined& refined, const Shape& model, const Shape& data, DescriptorKind kind);

/// Releases what is stretched without need, lays limbs at full length, and pairs again. The evidence stays: those that lie wrong get better
/// by this, too, and what may be lengthened at will fits anywhere, so the order of matches is that of cloths which keep their proportions.
void finish(Refined& refined, const Shape& model, const Shape& data, DescriptorKind kind);

/// The match with the pairs that are told and its warp; followed pairs have no number yet (data -1). Chamfer and the final handedness are
/// left to the family.
Match match_of(const Refined& refined, const Shape& model, const Shape& data, const Params& params);

}  // namespace homolog
