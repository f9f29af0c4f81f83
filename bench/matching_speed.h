// SPDX-License-Identifier: MIT
// What matching takes: the whole of `homolog match` on two shapes, and how it grows with points and matches.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "homolog/base/parameters.h"
#include "homolog/base/stopwatch.h"
#include "machine_floor.h"

namespace homolog::bench {

struct MatchingOptions {
  std::vector<int> grids, threads, points, copies;
  std::vector<std::pair<std::string, std::string>> pairs;  ///< files of model and data
  int repeats;
};

/// The stages of some work by every grid and number of threads, and how they grow with the grid.
void measure_on_grids(const std::string& name, const MatchingOptions& options, const MachineFloor& floor,
                      const std::function<void(const Params&, Stopwatch&)>& work);

/// All that `homolog match --json` does but starting and printing, on shapes made in code of about 10 000 vertices, each against a turned,
/// larger and bent copy of itself, and on the pairs.
void measure_whole_matches(const MatchingOptions& options, const MachineFloor& floor);

/// The stages of matching two balls with about so many salient points, all of which are searched.
void measure_points(const MatchingOptions& options);

/// The stages of matching a hand with scenes of so many hands, and the parts that the matches cover.
void measure_copies(const MatchingOptions& options);

}  // namespace homolog::bench
