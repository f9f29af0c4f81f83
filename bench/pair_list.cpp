// SPDX-License-Identifier: MIT
// Columns are separated by tabs: task, model, data, truth, and what else the list keeps for the reader.
#include "pair_list.h"

#include <fmt/format.h>

#include <sstream>

#include "text_lines.h"

namespace homolog::bench {

std::vector<PairEntry> read_pairs(const std::filesystem::path& folder) {
  TextLines lines{.file = folder / "pairs.tsv"};
  if (!lines.in) throw FileError(fmt::format("{}: cannot be read", lines.file.string()));
  if (!next_line(lines) || !lines.line.starts_with("task\tmodel\tdata")) {
    throw fault_at(lines, "expected the columns' names: task, model, data, separated by tabs");
  }
  std::vector<PairEntry> pairs;
  while (next_line(lines)) {
    if (lines.line.empty()) continue;
    std::istringstream columns(lines.line);
    PairEntry pair;
    for (std::string* column : {&pair.task, &pair.model, &pair.data, &pair.truth}) std::getline(columns, *column, '\t');
    if (pair.data.empty()) throw fault_at(lines, "expected at least task, model and data");
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

std::string set_of(const PairEntry& pair) { return std::filesystem::path(pair.model).parent_path().string(); }

}  // namespace homolog::bench
