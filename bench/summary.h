// SPDX-License-Identifier: MIT
// What the bench prints: a row a pair, and a summary per task and per set.
#pragma once

#include <string>
#include <vector>

#include "pair_list.h"
#include "score.h"

namespace homolog::bench {

struct Result {
  PairEntry pair;
  bool judged = true;  ///< false: the folder knows no truth of this pair
  PairScore score;
  double cpu_seconds = 0;
  std::string counts;  ///< what each stage let through
  std::string told;    ///< the first match's pairs by their numbers, as "0:4 3:17"
};

/// Column names and values of a row, separated by tabs (for files).
std::string row_header();
std::string row(const Result& result);

/// The row as a line of readable columns.
std::string readable_row(const Result& result);
std::string readable_header();

/// The table per task and per set, calibration of the confidence, handedness, and where right answers were lost.
std::string summary(const std::vector<Result>& results);

/// Why the run has not measured what it was asked to: no pairs, or some threw. Empty when it has.
std::string complaint(const std::vector<Result>& results);

/// Expected calibration error of the first match's confidence against its success, in 5 bins over the found.
double calibration_error(const std::vector<const Result*>& results);

}  // namespace homolog::bench
