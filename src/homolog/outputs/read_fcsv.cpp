// SPDX-License-Identifier: MIT
#include "homolog/outputs/read_fcsv.h"

#include <fmt/format.h>

#include <algorithm>

#include "homolog/outputs/csv_cells.h"
#include "homolog/outputs/landmark_position.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

struct Header {
  std::optional<Vec3> lps_signs;
  std::vector<std::string> columns{"id", "x", "y", "z", "ow", "ox", "oy", "oz", "vis", "sel", "lock", "label", "desc", "associatedNodeID"};
};

Vec3 signs_of(Text& text, const std::string& system) {
  if (system == "LPS" || system == "1") return {1, 1, 1};
  if (system == "RAS" || system == "0") return {-1, -1, 1};
  fail(text, fmt::format("the coordinate system '{}' is not known; save the points as LPS or RAS", shown(system)));
}

/// What stands after "# NAME =", if the line says that.
std::optional<std::string_view> value_of(std::string_view line, std::string_view name) {
  line.remove_prefix(1);
  const std::size_t equals = line.find('=');
  std::string_view key = line.substr(0, equals);
  if (equals == line.npos || take_word(key) != name) return {};
  line.remove_prefix(equals + 1);
  return line;
}

void read_comment(Text& text, std::string_view line, Header& header) {
  if (const auto system = value_of(line, "CoordinateSystem")) {
    header.lps_signs = signs_of(text, csv_cells(text, *system).front());
  } else if (const auto columns = value_of(line, "columns")) {
    header.columns = csv_cells(text, *columns);
  }
}

MarkupPoint read_row(Text& text, const std::vector<std::string>& cells, const Header& header) {
  const auto cell = [&](const char* name) -> std::string_view {
    const auto found = std::find(header.columns.begin(), header.columns.end(), name);
    const auto column = static_cast<std::size_t>(found - header.columns.begin());
    return column < cells.size() && found != header.columns.end() ? std::string_view(cells[column]) : std::string_view();
  };
  MarkupPoint point{std::string(cell("label")), std::string(cell("desc")), {}};
  point.display = {cell("sel") != "0", cell("lock") == "1", cell("vis") != "0"};
  const bool status_known = cells.size() > header.columns.size() && !cells[header.columns.size()].empty();
  if (status_known && cells[header.columns.size()] != "2") return point;
  point.position = landmark_cells(text, {cell("x"), cell("y"), cell("z")});
  if (point.position) point.position = header.lps_signs->cwiseProduct(*point.position);
  return point;
}

}  // namespace

std::vector<MarkupPoint> read_fcsv(const std::string& content, const std::string& file) {
  Text text{file, content, 0};
  Header header;
  std::vector<MarkupPoint> points;
  std::string_view line;
  while (next_line(text, line)) {
    if (line.find_first_not_of(" \t") == line.npos) continue;
    if (line[0] == '#') {
      read_comment(text, line, header);
      continue;
    }
    if (!header.lps_signs) {
      fail(text, "no line '# CoordinateSystem = LPS' or RAS comes before the points; save them with a newer 3D Slicer, or write that line");
    }
    const std::vector<std::string> cells = csv_cells(text, line);
    if (cells.size() < 4) fail(text, fmt::format("{} cells, but a point needs its id and three coordinates", cells.size()));
    points.push_back(read_row(text, cells, header));
  }
  return points;
}

}  // namespace homolog
