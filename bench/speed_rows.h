// SPDX-License-Identifier: MIT
// The table of bench_speed.
#pragma once

#include <string>
#include <vector>

#include "homolog/base/stopwatch.h"
#include "machine_floor.h"

namespace homolog::bench {

/// What was measured, and how: a shape or a pair of them, voxels along the longest side, threads (0: all).
struct Measured {
  std::string name;
  int grid, threads;
};

void print_speed_header();

/// A row for all stages of a name, with ratios to the machine's floor for those that arithmetic or memory bound, and one for all.
void print_speed_rows(const Measured& measured, const std::vector<Stage>& stages, const MachineFloor& floor);

}  // namespace homolog::bench
