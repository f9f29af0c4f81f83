// SPDX-License-Identifier: MIT
// Runs the public API on every pair of a list and judges what comes back.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "homolog/homolog.h"
#include "summary.h"

namespace homolog::bench {

struct RunOptions {
  Params params;
  std::uint64_t seed = 1;  ///< turns the data shapes; 0: not
  int threads = 2;         ///< pairs at a time; each works on one thread, so that its CPU time is its own
};

/// Calls `report` for every pair, in the order of the list, as soon as it and all before it are done. Never throws for a pair.
std::vector<Result> run_pairs(const std::filesystem::path& folder, const std::vector<PairEntry>& pairs, const RunOptions& options,
                              const std::function<void(const Result&)>& report);

}  // namespace homolog::bench
