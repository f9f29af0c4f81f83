// SPDX-License-Identifier: MIT
// homolog generate KIND: the manual page and the completions for shells, which the build installs. Help does not show it.
#include <fmt/format.h>

#include <memory>

#include "completions.h"
#include "console.h"
#include "exit_codes.h"
#include "manual_page.h"
#include "verbs.h"

namespace homolog::cli {
namespace {

std::string generated(const CLI::App& program, const std::string& kind) {
  if (kind == "man") return manual_page(program);
  const ListedProgram listed{listed_options(program), listed_verbs(program)};
  if (kind == "bash") return bash_completion(listed);
  if (kind == "zsh") return zsh_completion(listed);
  if (kind == "fish") return fish_completion(listed);
  throw UsageError(fmt::format("cannot generate '{}'; there are man, bash, zsh and fish", kind));
}

}  // namespace

Verb add_generate(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("generate", "Print the manual page, or the completions of a shell.")->group("");
  verb->footer("");
  const auto kind = std::make_shared<std::string>();
  verb->add_option("KIND", *kind, "man, bash, zsh or fish.")->type_name("")->required();
  return {verb, [kind, &program] {
            print_result(generated(program, *kind));
            return static_cast<int>(kFound);
          }};
}

}  // namespace homolog::cli
