// SPDX-License-Identifier: MIT
#include "homolog/outputs/read_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "homolog/base/errors.h"
#include "homolog/base/read_file.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

/// The cells of a line; a quoted cell may hold commas, and quotes written twice.
std::vector<std::string> split(Text& text, std::string_view line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += line[i++];
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += line[i];
    }
  }
  if (quoted) fail(text, "a quotation mark is not closed");
  for (std::string& cell : cells) {
    cell.erase(0, cell.find_first_not_of(" \t"));
    cell.erase(cell.find_last_not_of(" \t") + 1);
  }
  return cells;
}

struct Columns {
  std::array<std::size_t, 3> position;
  std::optional<std::size_t> label;
  std::size_t count;
};

Columns read_header(Text& text, std::string_view line) {
  if (line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);  // a byte order mark, as spreadsheets write it
  const std::vector<std::string> names = split(text, line);
  const auto find = [&](const char* name) { return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin()); };
  Columns columns{{find("x"), find("y"), find("z")}, {}, names.size()};
  if (std::max({columns.position[0], columns.position[1], columns.position[2]}) == names.size()) {
    fail(text, "the header must name the columns x, y and z (and label), separated by commas");
  }
  if (find("label") < names.size()) columns.label = find("label");
  return columns;
}

bool is_missing(const std::string& cell) { return cell.empty() || cell == "NA"; }

MarkupPoint read_row(Text& text, const std::vector<std::string>& cells, const Columns& columns) {
  if (cells.size() != columns.count) fail(text, fmt::format("{} cells, but the header has {}", cells.size(), columns.count));
  MarkupPoint point;
  if (columns.label) point.label = cells[*columns.label];
  Vec3 position;
  int missing = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string& cell = cells[columns.position[axis]];
    if (is_missing(cell)) {
      ++missing;
      continue;
    }
    std::string_view rest = cell;
    position[axis] = take_number(text, rest, "a coordinate");
    if (!take_word(rest).empty()) fail(text, fmt::format("'{}' is not a number, but a coordinate must be one", shown(cell)));
  }
  if (missing == 0) point.position = position;
  if (missing == 1 || missing == 2) fail(text, "some coordinates are missing, but not all; a missing point has none");
  return point;
}

}  // namespace

std::vector<MarkupPoint> read_points_csv(const std::string& content, const std::string& file) {
  Text text{file, content, 0};
  std::string_view line;
  if (!next_line(text, line)) fail(text, "the file is empty");
  const Columns columns = read_header(text, line);
  std::vector<MarkupPoint> points;
  while (next_line(text, line)) {
    if (line.find_first_not_of(" \t") != line.npos) points.push_back(read_row(text, split(text, line), columns));
  }
  return points;
}

std::vector<MarkupPoint> read_points(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".csv") return read_points_csv(read_file(path), path.string());
  if (extension == ".json") return read_markups(read_file(path), path.string());
  check_file(path);
  throw FileError(fmt::format("{}: points are read from .csv and .mrk.json; save them as one of these", path.string()));
}

}  // namespace homolog
