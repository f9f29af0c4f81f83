// SPDX-License-Identifier: MIT
// Completions of the program's verbs, options and their words, as scripts for shells.
#pragma once

#include <string>
#include <vector>

#include "option_list.h"

namespace homolog::cli {

struct ListedProgram {
  std::vector<ListedOption> options;
  std::vector<ListedVerb> verbs;
};

std::string bash_completion(const ListedProgram& program);
std::string zsh_completion(const ListedProgram& program);
std::string fish_completion(const ListedProgram& program);

}  // namespace homolog::cli
