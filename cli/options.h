// SPDX-License-Identifier: MIT
// Options that verbs share. Every row of the parameter table becomes a flag by itself.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <optional>
#include <string>

#include "homolog/base/parameters.h"
#include "homolog/shape/label_surface.h"
#include "homolog/shape/mesh.h"
#include "input_limits.h"

namespace homolog::cli {

struct ParameterOptions {
  std::string preset = "default";
  std::map<std::string, std::string> given;  ///< by the parameter's name, only what stands on the command line
};

struct CommonOptions {
  ParameterOptions parameters;
  std::string threads = "0";
  std::string out;
  Limits limits;
  bool json = false, quiet = false, timing = false;
};

/// --preset alone, and with one flag per parameter.
void add_preset_option(CLI::App& verb, ParameterOptions& options);
void add_common_options(CLI::App& verb, CommonOptions& options);
CLI::Option* add_out_option(CLI::App& verb, std::string& out);
void add_timing_option(CLI::App& verb, bool& timing);
void add_threads_option(CLI::App& verb, std::string& threads);
/// An option such as --part; an empty text is refused, for a forgotten shell variable does not mean the whole.
void add_part_option(CLI::App& verb, const char* name, std::optional<Box>& part);

/// The preset with every given flag on top, wherever they stand. Throws ParamError or UsageError.
Params params_of(const ParameterOptions& options);
Params params_of(const CommonOptions& options);

/// The value of --threads. Throws UsageError.
int parse_threads(const std::string& text);

/// Which voxels of a label volume, as `name`.
void add_label_option(CLI::App& verb, const char* name, Label& label);

}  // namespace homolog::cli
