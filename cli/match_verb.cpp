// SPDX-License-Identifier: MIT
// homolog match MODEL DATA: every place where the model, or a part of it, occurs in the data.
#include <fmt/format.h>

#include <memory>

#include "exit_codes.h"
#include "family_results.h"
#include "self_match.h"
#include "verbs.h"

namespace homolog::cli {
namespace {

struct MatchOptions {
  CommonOptions common;
  std::string model, data;
  std::optional<Box> model_part, data_part;
  Label model_label, data_label;
  bool self = false;
};

constexpr const char* kExamples = R"(Examples:
  # Find one bear in the other and look at bears/report.html
  homolog match bear.off bear_bis.off --out bears
  # Find the upper half of one bear in the other
  homolog match bear.off bear_bis.off --model-part "y>0.5"
  # Mirror images are not wanted; the result as JSON
  homolog match bear.off bear_bis.off --mirror forbid --json
  # On a coarser grid, in less time
  homolog match bear.off bear_bis.off --resolution 96

The confidence of a match is the probability that it is right. When none reaches one half, a sentence under the table says so; the exit code is
0 all the same. bending and chamfer are 0 for an exact copy; the last two columns tell how much of each surface the match explains.)";

int run_match(const MatchOptions& options) {
  if (options.self) {
    if (!options.data.empty() || options.data_part || options.data_label) {
      throw UsageError("with --self there is only one shape and no DATA");
    }
    return match_with_itself(options.model, options.model_part, options.model_label, options.common);
  }
  if (options.data.empty()) throw UsageError("match needs a second file, DATA, or --self");
  const Params params = params_of(options.common);
  const ResultFolder folder(options.common.out, {options.model, options.data});
  Console console(options.common.quiet, options.common.timing);
  const DescribedFile model = describe_file(options.model, options.model_part, params, options.common.limits, console, options.model_label);
  const DescribedFile data = describe_file(options.data, options.data_part, params, options.common.limits, console, options.data_label);
  console.stage("matching");
  return deliver(model, data, match_shapes(model.shape, data.shape, params, &console.watch()), params, options.common, folder, console);
}

}  // namespace

Verb add_match(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("match", "Find every place where MODEL, or a part of it, occurs in DATA.");
  const auto options = std::make_shared<MatchOptions>();
  verb->add_option("MODEL", options->model, fmt::format("The shape to be found: {}.", kShapeHelp))->type_name("")->required();
  verb->add_option("DATA", options->data, "The shape to search.")->type_name("");
  verb->add_flag("--self", options->self, "Match MODEL with itself, as 'homolog symmetry' does.");
  add_part_option(*verb, "--model-part", options->model_part);
  add_part_option(*verb, "--data-part", options->data_part);
  add_label_option(*verb, "--model-label", options->model_label);
  add_label_option(*verb, "--data-label", options->data_label);
  add_common_options(*verb, options->common);
  verb->footer(kExamples);
  return {verb, [options] { return run_match(*options); }};
}

}  // namespace homolog::cli
