// SPDX-License-Identifier: MIT
// bench_accuracy: how right homolog is on a folder of shape pairs with truth (bench/README.md tells the form of the folder).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>

#include "generate.h"
#include "homolog/shape/read_mesh.h"
#include "settings.h"
#include "solids.h"

namespace {

using namespace homolog;
using namespace homolog::bench;

struct Options {
  std::string folder, filter, only, preset, rows;
  std::vector<std::string> parameters;
  bool generate = false;
  std::vector<std::string> meshes;
  int strangers = 4;
  RunOptions run;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("FOLDER", options.folder, "Folder with pairs.tsv, shapes and truth");
  app.add_flag("--generate", options.generate, "Instead of a folder: cases made from solids of its own and from the meshes given");
  app.add_option("--mesh", options.meshes, "A closed mesh to generate cases from, too (repeatable)");
  app.add_option("--strangers", options.strangers, "Shapes that share nothing, for every mesh generated from")->capture_default_str();
  app.add_option("--filter", options.filter, "Only pairs with this text in the name of model or data");
  app.add_option("--only", options.only, "Only this task")->check(CLI::IsMember({"whole", "part", "mirror", "scene", "unrelated"}));
  app.add_option("--threads", options.run.threads, "Pairs at a time")->check(CLI::Range(1, 64))->capture_default_str();
  app.add_option("--param", options.parameters, "NAME=VALUE, a parameter other than by default (repeatable)")->take_all();
  app.add_option("--preset", options.preset, "Start from these parameters")->check(CLI::IsMember({"paper"}));
  app.add_option("--turn", options.run.seed, "Seed of the random turn, scale and shift of the data; 0: none")->capture_default_str();
  app.add_option("--turn-model", options.run.model_seed, "Seed of the like of the model; 0: none")->capture_default_str();
  app.add_option("--rows", options.rows, "Also write the rows to this file, separated by tabs");
}

std::vector<Case> all_cases(const Options& options) {
  if (!options.generate) return cases_of(options.folder, read_pairs(options.folder));
  std::vector<NamedMesh> meshes = example_meshes();
  for (const std::filesystem::path path : options.meshes) meshes.push_back({path.stem().string(), read_mesh(path)});
  return generated_cases(meshes, strangers(options.strangers), options.run.seed);
}

std::vector<Case> chosen_cases(const Options& options) {
  std::vector<Case> cases = all_cases(options);
  std::erase_if(cases, [&](const Case& one) {
    const bool named = one.pair.model.find(options.filter) != std::string::npos || one.pair.data.find(options.filter) != std::string::npos;
    return !named || (!options.only.empty() && one.pair.task != options.only);
  });
  return cases;
}

// The exit status: 1 when there is something to complain of.
int run(const Options& options) {
  std::ofstream rows;
  if (!options.rows.empty()) {
    rows.open(options.rows);
    if (!rows) throw OutputError(fmt::format("{}: cannot be written", options.rows));
    rows << row_header() << '\n';
  }
  fmt::print("{}\n", readable_header());
  const std::vector<Result> results = run_cases(chosen_cases(options), options.run, [&](const Result& result) {
    fmt::print("{}\n", readable_row(result));
    std::fflush(stdout);
    if (rows.is_open()) rows << row(result) << '\n' << std::flush;
  });
  fmt::print("\n{}", summary(results));
  const std::string wrong = complaint(results);
  if (!wrong.empty()) fmt::print(stderr, "bench_accuracy: {}\n", wrong);
  return wrong.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("How right homolog is on a folder of shape pairs with truth");
  Options options;
  add_options(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    if (options.folder.empty() != options.generate) throw ParamError("give either a FOLDER or --generate");
    if (!options.preset.empty()) options.run.params = preset(options.preset);
    set_parameters(options.run.params, options.parameters);
    return run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_accuracy: {}\n", error.what());
    return 2;
  }
}
