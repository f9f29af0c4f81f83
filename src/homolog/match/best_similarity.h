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

/// Weighed means of both sides, at the origin if no pair counts, and the sum of the weights.
struct Means {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  double weight = 0;
};
Means means_of(const std::vector<WeighedPair>& pairs);

/// The similarity that minimises sum w |s(from) - to|^2 (Umeyama 1991). Pairs that all come from one place, or of which none counts, are
/// moved without turn and scale.
Similarity best_similarity(const std::vector<WeighedPair>& pairs, Chirality chirality);

}  // namespace homolog
