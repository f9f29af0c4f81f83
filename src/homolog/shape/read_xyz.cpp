// SPDX-License-Identifier: MIT
#include "homolog/shape/read_xyz.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "homolog/shape/text.h"

namespace homolog {
namespace {

constexpr double most_off_unit = 0.1;  // of a normal's length: rounded to two digits it still passes, a colour does not

constexpr std::size_t longest_count = 15;  // characters of a line

bool is_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error != std::errc::invalid_argument && end == word.data() + word.size();
}

std::size_t count_words(std::string_view line) {
  std::size_t words = 0;
  while (!take_word(line).empty()) ++words;
  return words;
}

/// The next line with data; CloudCompare writes the names of the columns behind two slashes.
bool next_row(Text& text, std::string_view& line) {
  while (next_data_line(text, line)) {
    if (!line.substr(line.find_first_not_of(" \t")).starts_with("//")) return true;
  }
  return false;
}

/// The number of points that stands alone in the first line of some files, which is taken off; none if there is none.
std::optional<long long> take_count(Text& text) {
  Text ahead = text;
  std::string_view line;
  if (!next_row(ahead, line) || line.size() > longest_count || count_words(line) != 1) return {};
  if (line.find_first_not_of(" \t\r0123456789") != line.npos) return {};
  text = ahead;
  return take_integer(text, line, "the number of points");
}

bool is_nan(std::string_view line) {
  const std::string_view word = take_word(line);
  return word == "nan" || word == "NaN" || word == "-nan" || word == "NAN";
}

/// Zero where the file says that there is none.
Vec3 take_normal(Text& text, std::string_view& line) {
  if (is_nan(line)) return Vec3::Zero();
  Vec3 normal;
  for (int axis = 0; axis < 3; ++axis) normal[axis] = take_number(text, line, "a normal's coordinate");
  const double length = normal.norm();
  if (length != 0 && !(std::abs(length - 1) <= most_off_unit)) {
    fail(text,
         fmt::format("columns 4 to 6 must be a normal of length 1, but have the length {:.3g}; a colour, perhaps: save x y z nx ny nz",
                     length));
  }
  return normal;
}

}  // namespace

bool is_xyz(std::string_view content) {
  Text text{"", content};
  std::string_view line;
  take_count(text);
  if (!next_row(text, line)) return false;
  std::size_t numbers = 0;
  for (std::string_view word = take_word(line); !word.empty(); word = take_word(line), ++numbers) {
    if (!is_number(word)) return false;
  }
  return numbers >= 3;
}

PointCloud read_xyz(std::string_view content, const std::string& file) {
  Text text{file, content};
  PointCloud cloud;
  std::string_view line;
  const std::optional<long long> announced = take_count(text);
  long long rows = 0;
  for (; next_row(text, line); ++rows) {
    const std::size_t columns = count_words(line);
    if (columns == 3) fail(text, without_normals);
    if (columns != 6) {
      fail(text, fmt::format("a line must have the six columns x y z nx ny nz with blanks between them, but has {}", columns));
    }
    const Vec3 point = take_position(text, line), normal = take_normal(text, line);
    if (normal.isZero(0)) continue;
    cloud.points.push_back(point);
    cloud.normals.push_back(normal);
  }
  if (announced && *announced != rows) {
    fail(text, fmt::format("{} points are announced in the first line, but {} follow; the file is truncated or damaged", *announced, rows));
  }
  if (cloud.points.empty()) fail(text, without_normals);
  return cloud;
}

}  // namespace homolog
