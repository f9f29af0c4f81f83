// SPDX-License-Identifier: MIT
// Sec. 6.2.2: growing a seed into a maximal set of correspondences that bends space little.
// Differs: instead of cliques of candidates that each go with the seed, the set's own spline predicts place, spread and size of every
// further point; the likeliest candidate joins and the spline is laid anew (docs/paper_map.md). One-to-one by construction.
#pragma once

#include <optional>
#include <vector>

#include "homolog/describe/shape.h"
#include "homolog/match/match.h"
#include "homolog/match/seeds.h"

namespace homolog {

/// A grown set before refinement.
struct GrownSet {
  CorrespondenceSet pairs;
  Chirality chirality = Chirality::proper;
  ThinPlateSpline spline;
  std::optional<std::size_t> drawn_from;  ///< a node of the model: it is drawn on to the data from there outwards; at once, if none
  double score = 0;                       ///< 1 - cost / limit summed over the pairs that joined, 1/2 for each of the seed
};

/// The set that grows from a seed by `candidates`, which stand by model point. `bending` in shares of the model's diagonal.
GrownSet grow_seed(const Seed& seed, Chirality chirality, const CorrespondenceSet& candidates, const Shape& model, double bending);

}  // namespace homolog
