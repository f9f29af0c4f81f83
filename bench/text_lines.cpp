// SPDX-License-Identifier: MIT
#include "text_lines.h"

#include <fmt/format.h>

namespace homolog::bench {

bool next_line(TextLines& lines) {
  ++lines.number;
  if (!std::getline(lines.in, lines.line)) return false;
  if (lines.line.ends_with('\r')) lines.line.pop_back();
  return true;
}

bool next_entry(TextLines& lines) {
  while (next_line(lines)) {
    if (!lines.line.empty() && lines.line[0] != '#') return true;
  }
  return false;
}

FileError fault_at(const std::filesystem::path& file, int line, const std::string& what) {
  return FileError(fmt::format("{}, line {}: {}", file.string(), line, what));
}

FileError fault_at(const TextLines& lines, const std::string& what) { return fault_at(lines.file, lines.number, what); }

}  // namespace homolog::bench
