// SPDX-License-Identifier: MIT
#include "homolog/shape/obj_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace homolog {
namespace {

/// Whether the next line belongs to this one. A name may itself end in a backslash, as a folder of Windows does; one that goes on has a
/// blank before it.
bool goes_on(std::string_view line) {
  static constexpr std::string_view names[] = {"mtllib", "usemtl", "newmtl", "o", "g"};
  if (line.empty() || line.back() != '\\') return false;
  std::string_view rest = line;
  const bool is_name = std::find(std::begin(names), std::end(names), take_word(rest)) != std::end(names);
  return !is_name || line.find_last_of(" \t") + 2 == line.size();
}

}  // namespace

bool next_whole_line(Text& text, std::string_view& line, std::string& joined) {
  if (!next_data_line(text, line)) return false;
  if (!goes_on(line)) return true;
  joined.clear();
  bool more = true;
  while (more && !line.empty() && line.back() == '\\') {
    joined.append(line.substr(0, line.size() - 1)).append(" ");
    more = next_line(text, line);
  }
  if (more) joined.append(line);
  line = joined;
  return true;
}

std::uint32_t obj_number(Text& text, std::string_view word, std::size_t so_far, const char* what) {
  const long long written = take_integer(text, word, fmt::format("the {} number of a face", what).c_str());
  const long long index = written < 0 ? static_cast<long long>(so_far) + written : written - 1;
  if (written == 0 || index < 0 || index > 0xfffffffeLL) {
    fail(text, fmt::format("{} {} does not exist (they count from 1); the file is damaged", what, written));
  }
  return static_cast<std::uint32_t>(index);
}

}  // namespace homolog
