// SPDX-License-Identifier: MIT
#include "option_list.h"

#include <algorithm>

#include "homolog/base/parameters.h"

namespace homolog::cli {
namespace {

std::vector<std::string> choices_of(const std::string& option) {
  for (const ParameterInfo& info : parameter_table()) {
    if ("--" + info.name == option) return info.choices;
  }
  return {};
}

ListedOption listed(const CLI::Option& option) {
  ListedOption row;
  row.sentence = option.get_description();
  row.required = option.get_required();
  if (option.get_lnames().empty()) {
    row.name = row.value = option.get_name(true);
    return row;
  }
  row.name = "--" + option.get_lnames().front();
  if (option.get_items_expected_max() > 0) row.value = option.get_type_name();
  row.group = option.get_group();
  row.choices = choices_of(row.name);
  return row;
}

}  // namespace

std::vector<ListedOption> listed_options(const CLI::App& app) {
  std::vector<ListedOption> rows;
  for (const CLI::Option* option : app.get_options()) rows.push_back(listed(*option));
  std::stable_partition(rows.begin(), rows.end(), [](const ListedOption& row) { return row.is_positional(); });
  return rows;
}

std::vector<ListedVerb> listed_verbs(const CLI::App& program) {
  std::vector<ListedVerb> verbs;
  for (const CLI::App* verb : program.get_subcommands({})) {
    if (verb->get_group().empty()) continue;
    verbs.push_back({verb->get_name(), verb->get_description(), verb->get_footer(), listed_options(*verb)});
  }
  return verbs;
}

}  // namespace homolog::cli
