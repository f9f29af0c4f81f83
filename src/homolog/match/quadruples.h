// SPDX-License-Identifier: MIT
// App. A and B: quadruples of correspondences from which sets may grow.
// In: candidate correspondences. Out: consistent quadruples, best score first.
// Differs: the score's sign (printed, it rewards bad descriptors), a scale-free pair test beside the printed one, and points without a
// direction take part (the paper has dropped them).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "homolog/base/parameters.h"
#include "homolog/match/match.h"

namespace homolog {

struct Quadruple {
  std::array<Correspondence, 4> pairs;
  double score = 0;  ///< epsilon(Q), 0 to 1
};

struct Quadruples {
  std::vector<Quadruple> best;  ///< best first, at most as many as asked for
  long consistent = 0;          ///< cliques of four candidates with a score above 0
  bool complete = true;         ///< false when there were more cliques than the search may visit
};

/// w_pq: how far the distances between two correspondences disagree with their radii. Printed: the greatest difference of the distances in
/// units of r_p and of r_q. Proportions: the greatest |log| of the same two proportions, which asks the same of near and of far pairs.
/// Infinite when they share a point.
double pair_mismatch(const Correspondence& p, const Correspondence& q, PairTest test);

/// A_Q: the affine map of the four model positions onto the data positions; nothing when the model positions lie in a plane.
std::optional<Eigen::Matrix<double, 3, 4>> affine_map(const std::array<Correspondence, 4>& Q);

/// d_a: the greatest angle between a direction mapped by A_Q and its partner. A pair where a direction is missing says nothing: it counts
/// as `unknown`.
double direction_mismatch(const std::array<Correspondence, 4>& Q, const Mat3& A, double unknown);

/// epsilon(Q); 0 for a quadruple that App. A discards (d_a >= t_a, flat) or App. B excludes (1/k(A) <= t_k).
double quadruple_score(const std::array<Correspondence, 4>& Q, const PaperParams& params);

/// The `most` best one-to-one quadruples of candidates whose pairs all have w < t_w. Ties keep the order of the candidates by descriptor
/// distance.
Quadruples find_quadruples(const std::vector<Correspondence>& candidates, std::size_t most, const PaperParams& params);

}  // namespace homolog
