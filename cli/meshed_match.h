// SPDX-License-Identifier: MIT
// A match found before with its two meshes laid onto each other: what 'homolog dense' and 'homolog morph' begin with.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "console.h"
#include "homolog/match/dense.h"
#include "stored_match.h"

namespace homolog::cli {

struct MeshedMatchOptions {
  StoredMatchOptions match;
  std::string model, data;  ///< the files of the meshes; empty: those beside the match
  std::string threads = "0";
  bool quiet = false, timing = false;
};

struct MeshedMatch {
  StoredFamily family;
  Mesh model, data;
  DenseMaps maps;  ///< by the match that the options choose
};

/// MATCH with its options, --model, --data, --threads, --quiet and --timing.
void add_meshed_match_options(CLI::App& verb, MeshedMatchOptions& options);

/// Reads and lays; none, and a message that says so, when MATCH holds no match. Throws FileError and UsageError.
std::optional<MeshedMatch> lay_meshed_match(const MeshedMatchOptions& options, Console& console);

/// The exit code, and a message when not one vertex of the model has a place.
int outcome(const DenseMaps& maps);

}  // namespace homolog::cli
