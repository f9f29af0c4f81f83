// SPDX-License-Identifier: MIT
// Sec. 6.2.1 and 6.2.2: quadruples of correspondences grow to maximal correct sets by cliques of compatible candidates.
// In: candidate correspondences C-hat. Out: correct sets, largest first.
// Differs: energies are made free of scale, sets are one-to-one, searches are budgeted, and a quadruple inside a set already found is
// skipped.
#pragma once

#include <vector>

#include "homolog/base/parameters.h"
#include "homolog/match/match.h"

namespace homolog {

struct GrownSets {
  std::vector<CorrespondenceSet> sets;  ///< largest first, then by the score of their quadruple; none is part of another
  long quadruples = 0;                  ///< consistent ones (App. A, B)
  long grown = 0;                       ///< those that were not part of a set already
  bool complete = true;                 ///< false when a budget cut a search short
};

/// Delta(f_S) of the paper's r^3 spline through x and y = x + r p, for a model of unit diagonal and data brought to the model's size by the
/// ratio of the spreads of the matched points: no unit and no scale remains, and t_Delta = 25 has a meaning. Pairs in which a point has no
/// direction give x only. Infinite when the model points lie in a plane.
double affine_free_bending(const CorrespondenceSet& S, double model_diagonal);

/// The maximal correct sets that grow from the best quadruples of the candidates, in sets sorted by (model, data). Work is counted, not
/// timed, so results repeat; some 0.1 s for 400 candidates.
GrownSets grow_quadruples(const std::vector<Correspondence>& candidates, double model_diagonal, const PaperParams& params);

}  // namespace homolog
