// SPDX-License-Identifier: MIT
// The verbs of the program, one file each.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace homolog::cli {

/// Its options live in `app`; run() does the work and returns the exit code.
struct Verb {
  CLI::App* app;
  std::function<int()> run;
};

Verb add_match(CLI::App& program);
Verb add_points(CLI::App& program);
Verb add_symmetry(CLI::App& program);
Verb add_dense(CLI::App& program);
Verb add_morph(CLI::App& program);
Verb add_transfer(CLI::App& program);
Verb add_params(CLI::App& program);
Verb add_generate(CLI::App& program);

}  // namespace homolog::cli
