// SPDX-License-Identifier: MIT
// Runs the public API on many pairs of shapes and judges what comes back.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "homolog/homolog.h"
#include "summary.h"

namespace homolog::bench {

/// Where a shape comes from; shapes of one name are read and described once.
struct ShapeSource {
  std::string name;
  std::function<Mesh()> read;
};

/// One pair with what is true of it: a truth for every copy of the model in the data, none when they share nothing.
struct Case {
  PairEntry pair;
  ShapeSource model, data;
  std::function<std::vector<TruePoints>(const Mesh& model, const Mesh& data)> truths;
};

/// The pairs of a folder with its truth.
std::vector<Case> cases_of(const std::filesystem::path& folder, const std::vector<PairEntry>& pairs);

struct RunOptions {
  Params params;
  std::uint64_t seed = 1;        ///< turns the data shapes; 0: not
  std::uint64_t model_seed = 0;  ///< turns the models; 0: not
  int threads = 2;               ///< pairs at a time; each works on one thread, so that its CPU time is its own
};

/// Calls `report` for every case, in their order, as soon as it and all before it are done. Never throws for a case.
std::vector<Result> run_cases(const std::vector<Case>& cases, RunOptions options, const std::function<void(const Result&)>& report);

}  // namespace homolog::bench
