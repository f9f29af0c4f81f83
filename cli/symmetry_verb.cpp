// SPDX-License-Identifier: MIT
// homolog symmetry SHAPE: its symmetries and repeated parts.
#include <fmt/format.h>

#include <memory>

#include "family_results.h"
#include "self_match.h"
#include "verbs.h"

namespace homolog::cli {
namespace {

struct SymmetryOptions {
  CommonOptions common;
  std::string shape;
  std::optional<Box> part;
  Label label;
};

constexpr const char* kExamples = R"(Examples:
  # Symmetries and repeated parts of a bear
  homolog symmetry bear.off --out bear_symmetry
  # Mirror symmetries alone
  homolog symmetry bear.off --mirror only

Under the table it says of each match what it does: the plane that mirrors the shape into itself, or how a part is scaled, turned and shifted
to where it is repeated; and how far from the surface it then lies. A bent body has a plane, too, but lies far from it. The same stands in
symmetry.json of the folder.)";

}  // namespace

int match_with_itself(const std::string& path, const std::optional<Box>& part, const Label& label, const CommonOptions& options) {
  const Params params = params_of(options);
  const ResultFolder folder(options.out, {path});
  Console console(options.quiet, options.timing);
  const DescribedFile file = describe_file(path, part, params, options.limits, console, label);
  console.stage("matching");
  return deliver(file, file, find_symmetries(file.shape, params, &console.watch()), params, options, folder, console, Against::itself);
}

Verb add_symmetry(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("symmetry", "Find a shape's symmetries and repeated parts.");
  const auto options = std::make_shared<SymmetryOptions>();
  verb->add_option("SHAPE", options->shape, fmt::format("The shape: {}.", kShapeHelp))->type_name("")->required();
  add_part_option(*verb, "--part", options->part);
  add_label_option(*verb, "--label", options->label);
  add_common_options(*verb, options->common);
  verb->footer(kExamples);
  return {verb, [options] { return match_with_itself(options->shape, options->part, options->label, options->common); }};
}

}  // namespace homolog::cli
