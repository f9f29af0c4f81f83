// SPDX-License-Identifier: MIT
// The similarity that moves places nearest to where they go.
#pragma once

#include <vector>

#include "homolog/match/thin_plate_spline.h"

namespace homolog {

/// Where something is and where it goes, and how much that counts.
struct WeighedPair {
  Vec3 from, to;
  double weight;
};

/// The similarity that minimises sum w |s(from) - to|^2 (Umeyama 1991). Pairs that all come from one place, or of which none counts, are
/// moved without turn and scale.
Similarity best_similarity(const std::vector<WeighedPair>& pairs, Chirality chirality);

}  // namespace homolog
