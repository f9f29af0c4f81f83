// SPDX-License-Identifier: MIT
#include "homolog/shape/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "homolog/base/errors.h"

namespace homolog {

std::string shown(std::string_view word, std::size_t longest) {
  std::string safe;
  for (const char c : word.substr(0, longest)) safe += c >= ' ' && c <= '~' ? c : '?';
  return safe;
}

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return std::tolower(c); });
  return result;
}

void fail(const Text& text, const std::string& what) { throw FileError(fmt::format("{}, line {}: {}", text.file, text.line, what)); }

bool next_line(Text& text, std::string_view& line) {
  if (text.rest.empty()) return false;
  const std::size_t end = text.rest.find('\n');
  line = text.rest.substr(0, end);
  text.rest.remove_prefix(end == std::string_view::npos ? text.rest.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  ++text.line;
  return true;
}

bool next_data_line(Text& text, std::string_view& line) {
  while (next_line(text, line)) {
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(" \t\r") != std::string_view::npos) return true;
  }
  return false;
}

std::string_view take_word(std::string_view& line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return line = {};
  const std::size_t end = std::min(line.find_first_of(" \t\r", begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

std::string rest_of(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
  return std::string(line.substr(0, line.find_last_not_of(" \t\r") + 1));
}

double take_number(Text& text, std::string_view& line, const char* what) {
  std::string_view word = take_word(line);
  if (word.empty()) fail(text, fmt::format("{} is missing; the file is truncated or damaged", what));
  if (word[0] == '+') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(word).c_str(), nullptr);  // 0 if too small, inf if too large
  const bool number = error != std::errc::invalid_argument && end == word.data() + word.size();
  if (!number && word.find_first_of(",;") != std::string_view::npos) {
    fail(text, fmt::format("'{}' is not a number; save it with a decimal point, and with blanks between numbers", shown(word)));
  }
  if (!number || !std::isfinite(value)) fail(text, fmt::format("'{}' is not a finite number, but {} must be one", shown(word), what));
  return value;
}

long long take_integer(Text& text, std::string_view& line, const char* what) {
  std::string_view word = take_word(line);
  if (word.empty()) fail(text, fmt::format("{} is missing; the file is truncated or damaged", what));
  if (word[0] == '+') word.remove_prefix(1);
  long long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) {
    fail(text, fmt::format("'{}' is not a whole number, but {} must be one", shown(word), what));
  }
  return value;
}

Vec3 take_position(Text& text, std::string_view& line) {
  Vec3 position;
  for (int axis = 0; axis < 3; ++axis) position[axis] = take_number(text, line, "a vertex coordinate");
  return position;
}

}  // namespace homolog
