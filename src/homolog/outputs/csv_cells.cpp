// SPDX-License-Identifier: MIT
#include "homolog/outputs/csv_cells.h"

#include <algorithm>

namespace homolog {
namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < ' ' && c != '\n'; }

/// Goes on with the last cell; whether that is still quoted at the end of the line.
bool take_cells(std::string_view line, char separator, bool quoted, std::vector<std::string>& cells) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += line[i++];
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == separator && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += line[i];
    }
  }
  return quoted;
}

}  // namespace

std::vector<std::string> csv_cells(Text& text, std::string_view line, char separator) {
  std::vector<std::string> cells(1);
  const std::size_t first_line = text.line;
  bool quoted = take_cells(line, separator, false, cells);
  while (quoted && next_line(text, line)) {
    cells.back() += '\n';
    quoted = take_cells(line, separator, quoted, cells);
  }
  if (quoted) {
    text.line = first_line;
    fail(text, "a quotation mark is not closed");
  }
  for (std::string& cell : cells) {
    cell.erase(0, cell.find_first_not_of(" \t"));
    cell.erase(cell.find_last_not_of(" \t") + 1);
  }
  return cells;
}

std::string csv_cell(std::string text) {
  std::replace_if(text.begin(), text.end(), is_control, ' ');
  if (text.find_first_of(",\"\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace homolog
