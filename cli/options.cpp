// SPDX-License-Identifier: MIT
#include "options.h"

#include <fmt/format.h>

#include "exit_codes.h"
#include "part.h"
#include "whole_number.h"

namespace homolog::cli {
namespace {

std::string flag_help(const ParameterInfo& info) {
  const std::string value = to_text(get_parameter({}, info.name));
  return fmt::format("{} {}{}{}; default {}.", info.sentence, range_text(info), info.unit.empty() ? "" : " ", info.unit, value);
}

/// A forgotten shell variable must not mean "no files, please".
std::string folder_name(const std::string& text) { return text.empty() ? "the folder has no name" : ""; }

}  // namespace

void add_preset_option(CLI::App& verb, ParameterOptions& options) {
  verb.add_option("--preset", options.preset, "Start from these parameters: default, or paper for the paper's choices.")->type_name("NAME");
}

int parse_threads(const std::string& text) { return static_cast<int>(whole_number("--threads", text, 0, 1024)); }

void add_label_option(CLI::App& verb, const char* name, Label& label) {
  const auto store = [&label, name](const std::string& text) { label = whole_number(name, text, -largest_label, largest_label); };
  verb.add_option_function<std::string>(name, store, "Of a label volume, the voxels of this value; 0 for all that are not 0.")
      ->type_name("N");
}

CLI::Option* add_out_option(CLI::App& verb, std::string& out) {
  return verb.add_option("--out", out, "Write all results into this folder.")->type_name("DIR")->check(folder_name);
}

void add_timing_option(CLI::App& verb, bool& timing) {
  verb.add_flag("--timing", timing, "Tell on stderr what each stage took, and the most memory the process had held until its end.");
}

void add_threads_option(CLI::App& verb, std::string& threads) {
  verb.add_option("--threads", threads, "Threads to use, 0 for all cores; results do not depend on it.")->type_name("N");
}

void add_part_option(CLI::App& verb, const char* name, std::optional<Box>& part) {
  verb.add_option_function<std::string>(
          name, [&part](const std::string& text) { part = parse_part(text); },
          "Use only this part, in shares of the bounding box: y>0.5, or x<0.3,z>0.2, or y=0.4..0.8.")
      ->type_name("SPEC");
}

void add_common_options(CLI::App& verb, CommonOptions& options) {
  add_out_option(verb, options.out);
  verb.add_flag("--json", options.json, "Print the result as JSON instead of a table.");
  verb.add_flag("--quiet", options.quiet, "No progress and no warnings.");
  add_timing_option(verb, options.timing);
  add_threads_option(verb, options.threads);
  add_limit_options(verb, options.limits);
  add_preset_option(verb, options.parameters);
  for (const ParameterInfo& info : parameter_table()) {
    const auto store = [&given = options.parameters.given, name = info.name](const std::string& value) { given[name] = value; };
    verb.add_option_function<std::string>("--" + info.name, store, flag_help(info))
        ->group("Parameters")
        ->type_name(info.choices.empty() ? info.integer ? "N" : "X" : "WORD");
  }
}

Params params_of(const ParameterOptions& options) {
  Params params = preset(options.preset);
  for (const auto& [name, value] : options.given) set_parameter(params, name, value);
  return params;
}

Params params_of(const CommonOptions& options) {
  Params params = params_of(options.parameters);
  params.threads = parse_threads(options.threads);
  return params;
}

}  // namespace homolog::cli
