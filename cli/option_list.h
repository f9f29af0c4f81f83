// SPDX-License-Identifier: MIT
// What the program understands, as plain lists: the source of its manual page and of the completions for shells.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace homolog::cli {

struct ListedOption {
  std::string name;                  ///< "--out", or "MODEL" for a positional one
  std::string value;                 ///< what stands behind it: FILE, DIR, N, ...; empty for a flag
  std::string sentence, group;       ///< group: "Options", "Parameters", ...; empty for a positional one
  std::vector<std::string> choices;  ///< the words that may stand behind it, if they are known
  bool required = false;

  bool is_positional() const { return name.front() != '-'; }
};

struct ListedVerb {
  std::string name, sentence, footer;
  std::vector<ListedOption> options;
};

/// The options of the program itself or of a verb, positional ones first.
std::vector<ListedOption> listed_options(const CLI::App& app);

/// The verbs that help shows, in its order.
std::vector<ListedVerb> listed_verbs(const CLI::App& program);

}  // namespace homolog::cli
