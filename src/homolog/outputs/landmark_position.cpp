// SPDX-License-Identifier: MIT
#include "homolog/outputs/landmark_position.h"

#include <fmt/format.h>

namespace homolog {
namespace {

bool is_missing(std::string_view word) { return word.empty() || word == "NA" || word == "NaN" || word == "nan" || word == "NAN"; }

}  // namespace

std::optional<Vec3> landmark_position(Text& text, const std::array<std::string_view, 3>& words, bool nines) {
  Vec3 position = Vec3::Zero();
  int missing = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::string_view rest = words[axis];
    if (!is_missing(rest)) {
      position[axis] = take_number(text, rest, "a coordinate");
      if (!take_word(rest).empty()) fail(text, fmt::format("'{}' is not a number, but a coordinate must be one", shown(words[axis])));
    }
    missing += is_missing(words[axis]) || (nines && position[axis] == missing_coordinate);
  }
  if (missing == 0) return position;
  if (missing < 3) fail(text, "some coordinates are missing, but not all; a missing point has none");
  return {};
}

std::optional<Vec3> landmark_cells(Text& text, const std::array<std::string_view, 3>& cells) {
  for (const std::string_view cell : cells) {
    if (cell.find(',') == cell.npos) continue;
    fail(text, fmt::format("'{}' is not a number; save it with a decimal point instead of the comma", shown(cell)));
  }
  return landmark_position(text, cells);
}

std::optional<Vec3> landmark_line(Text& text, std::string_view line, bool nines) {
  std::array<std::string_view, 3> words;
  for (std::string_view& word : words) word = take_word(line);
  if (words[2].empty()) fail(text, "a landmark needs three coordinates, x y z; those of pictures have two, and lie on no surface");
  if (!take_word(line).empty()) fail(text, "a landmark has three coordinates, but here are more");
  return landmark_position(text, words, nines);
}

}  // namespace homolog
