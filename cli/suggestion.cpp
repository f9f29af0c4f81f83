// SPDX-License-Identifier: MIT
#include "suggestion.h"

#include <algorithm>
#include <numeric>

namespace homolog::cli {
namespace {

/// Fewest insertions, deletions and replacements of a letter that turn a into b.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string suggestion(const std::string& typed, const std::vector<std::string>& words) {
  if (typed.starts_with("--")) {
    for (const std::string& word : words) {
      if (word.ends_with(typed.substr(1))) return "; did you mean '" + word + "'?";
    }
  }
  const auto nearer = [&](const std::string& a, const std::string& b) { return edit_distance(typed, a) < edit_distance(typed, b); };
  const auto nearest = std::min_element(words.begin(), words.end(), nearer);
  if (nearest == words.end() || edit_distance(typed, *nearest) > std::max<std::size_t>(1, nearest->size() / 3)) return "";
  return "; did you mean '" + *nearest + "'?";
}

}  // namespace homolog::cli
