// SPDX-License-Identifier: MIT
// Columns are separated by tabs: task, model, data, truth, and what else the list keeps for the reader.
#include "pair_list.h"

#include <fmt/format.h>

#include <sstream>

#include "homolog/base/errors.h"
#include "homolog/shape/text.h"
#include "truth_files.h"

namespace homolog::bench {

std::vector<PairEntry> read_pairs(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "pairs.tsv";
  if (!std::filesystem::exists(file)) throw FileError(fmt::format("{}: cannot be read", file.string()));
  const std::string content = content_of(file);
  Text text{file.string(), content};
  std::string_view line;
  if (!next_line(text, line) || !line.starts_with("task\tmodel\tdata")) {
    text.line = 1;  // of an empty file, too
    fail(text, "expected the columns' names: task, model, data, separated by tabs");
  }
  std::vector<PairEntry> pairs;
  while (next_line(text, line)) {
    if (line.empty()) continue;
    std::istringstream columns{std::string(line)};
    PairEntry pair;
    for (std::string* column : {&pair.task, &pair.model, &pair.data, &pair.truth}) std::getline(columns, *column, '\t');
    if (pair.data.empty()) fail(text, "expected at least task, model and data");
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

std::string set_of(const PairEntry& pair) { return std::filesystem::path(pair.model).parent_path().string(); }

}  // namespace homolog::bench
