// SPDX-License-Identifier: MIT
// bench_accuracy: how right homolog is on a folder of shape pairs with truth (bench/README.md tells the form of the folder).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>

#include "pair_list.h"
#include "run_pairs.h"
#include "summary.h"

namespace {

using namespace homolog;
using namespace homolog::bench;

struct Options {
  std::string folder, filter, only, preset, rows;
  std::vector<std::string> parameters;
  RunOptions run;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("FOLDER", options.folder, "Folder with pairs.tsv, shapes and truth")->required();
  app.add_option("--filter", options.filter, "Only pairs whose model or data contains this text");
  app.add_option("--only", options.only, "Only this task")->check(CLI::IsMember({"whole", "part", "mirror"}));
  app.add_option("--threads", options.run.threads, "Pairs at a time")->check(CLI::Range(1, 64))->capture_default_str();
  app.add_option("--param", options.parameters, "NAME=VALUE, a parameter other than by default (repeatable)")->take_all();
  app.add_option("--preset", options.preset, "Start from these parameters")->check(CLI::IsMember({"paper"}));
  app.add_option("--turn", options.run.seed, "Seed of the random turn, scale and shift of the data; 0: none")->capture_default_str();
  app.add_option("--rows", options.rows, "Also write the rows to this file, separated by tabs");
}

void set_parameters(Options& options) {
  if (options.preset == "paper") options.run.params = paper_preset();
  for (const std::string& text : options.parameters) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) throw ParamError(fmt::format("'--param {}': expected NAME=VALUE", text));
    set_parameter(options.run.params, text.substr(0, equals), text.substr(equals + 1));
  }
}

std::vector<PairEntry> chosen_pairs(const Options& options) {
  std::vector<PairEntry> pairs = read_pairs(options.folder);
  std::erase_if(pairs, [&](const PairEntry& pair) {
    const bool named = pair.model.find(options.filter) != std::string::npos || pair.data.find(options.filter) != std::string::npos;
    return !named || (!options.only.empty() && pair.task != options.only);
  });
  return pairs;
}

void run(const Options& options) {
  std::ofstream rows;
  if (!options.rows.empty()) {
    rows.open(options.rows);
    if (!rows) throw OutputError(fmt::format("{}: cannot be written", options.rows));
    rows << row_header() << '\n';
  }
  fmt::print("{}\n", readable_header());
  const std::vector<Result> results = run_pairs(options.folder, chosen_pairs(options), options.run, [&](const Result& result) {
    fmt::print("{}\n", readable_row(result));
    std::fflush(stdout);
    if (rows.is_open()) rows << row(result) << '\n' << std::flush;
  });
  fmt::print("\n{}", summary(results));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("How right homolog is on a folder of shape pairs with truth");
  Options options;
  add_options(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    set_parameters(options);
    run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_accuracy: {}\n", error.what());
    return 2;
  }
  return 0;
}
