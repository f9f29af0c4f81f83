// SPDX-License-Identifier: MIT
// Columns are separated by tabs: task, model, data, truth, and what else the list keeps for the reader.
#include "pair_list.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "homolog/base/errors.h"

namespace homolog::bench {

std::vector<PairEntry> read_pairs(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "pairs.tsv";
  std::ifstream in(path);
  if (!in) throw FileError(fmt::format("{}: cannot be read", path.string()));
  std::vector<PairEntry> pairs;
  std::string line;
  std::getline(in, line);
  for (int number = 2; std::getline(in, line); ++number) {
    if (line.empty()) continue;
    std::istringstream columns(line);
    PairEntry pair;
    for (std::string* column : {&pair.task, &pair.model, &pair.data, &pair.truth}) std::getline(columns, *column, '\t');
    if (pair.data.empty()) throw FileError(fmt::format("{}, line {}: expected at least task, model and data", path.string(), number));
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

std::string set_of(const PairEntry& pair) { return std::filesystem::path(pair.model).parent_path().string(); }

}  // namespace homolog::bench
