// SPDX-License-Identifier: MIT
// The least times of work that is done several times, and with which power of its size they grow.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "homolog/base/stopwatch.h"

namespace homolog::bench {

/// The stages of `repeats` runs of the same work: the least time of each.
std::vector<Stage> best_stages(int repeats, const std::function<void(Stopwatch&)>& work);

/// Stages of one name as one, where the first of them stood: those of two shapes, for example.
std::vector<Stage> by_name(const std::vector<Stage>& stages);

double sum_of(const std::vector<Stage>& stages, double Stage::*what);

/// CPU time of each stage, and of all together, by size.
using Growth = std::map<std::string, std::vector<std::pair<double, double>>>;
void add_times(Growth& growth, double size, const std::vector<Stage>& stages);

/// "  voxels N^1.1  all N^1.5", by least squares over the logarithms of what takes a millisecond and more; nothing of stages with
/// fewer than two sizes.
std::string told_exponents(const Growth& growth, const std::string& symbol);

}  // namespace homolog::bench
