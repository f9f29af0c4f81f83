// SPDX-License-Identifier: MIT
// Beyond the paper: which ends of two bodies (describe/ends.h) may correspond, by the ways between them inside the bodies alone.
#pragma once

#include <utility>
#include <vector>

#include "homolog/describe/ends.h"

namespace homolog {

/// One-to-one pairs of ends, (of the model, of the data), whose ways agree up to one scale.
struct EndPairs {
  std::vector<std::pair<int, int>> pairs;
  double log_scale = 0;  ///< mean logarithm of how much longer the data's ways are
  double score = 0;      ///< number of pairs, each counted by how well its ways agree
};

/// Up to `most` sets of at least three pairs, the best score first.
std::vector<EndPairs> pair_ends(const Ends& model, const Ends& data, std::size_t most);

}  // namespace homolog
