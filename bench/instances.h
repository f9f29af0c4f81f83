// SPDX-License-Identifier: MIT
// Families judged where the model occurs in the data several times, or not at all.
// A match is claimed when its confidence is at least 0.5.
#pragma once

#include <vector>

#include "score.h"

namespace homolog::bench {

/// The score under the truth that the family meets best, and how many of the instances it finds. A claimed match that is right for an
/// instance found before is a false claim, unless it is the other of its two left-right answers; that one counts for nothing.
/// With several truths the diagonal that tolerances are shares of is that of the instance, not of all data.
PairScore score_instances(const Family& family, const Points& model, const Points& data, const std::vector<Truth>& truths,
                          double data_diagonal);

/// Shapes that share nothing: success when no match is claimed.
PairScore score_unrelated(const Family& family, const Points& model, const Points& data);

/// Harmonic mean of the share of claims that are right and the share of instances found.
double instance_f1(const PairScore& score);

}  // namespace homolog::bench
