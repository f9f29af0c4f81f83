// SPDX-License-Identifier: MIT
#include "homolog/outputs/read_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "homolog/base/errors.h"
#include "homolog/base/read_file.h"
#include "homolog/outputs/csv_cells.h"
#include "homolog/outputs/landmark_editor.h"
#include "homolog/outputs/landmark_position.h"
#include "homolog/outputs/morphologika.h"
#include "homolog/outputs/read_fcsv.h"
#include "homolog/outputs/specimen.h"
#include "homolog/outputs/tps.h"
#include "homolog/outputs/utf8_text.h"
#include "homolog/shape/foreign_file.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

struct Columns {
  std::array<std::size_t, 3> position;
  std::optional<std::size_t> label;
  std::size_t count;
  char separator;
};

/// As spreadsheets write it: the one that a first line "sep=;" names, or the first of these that is in the header.
char separator_of(Text& text, std::string_view& line) {
  constexpr std::string_view named = "sep=";
  if (line.size() > named.size() && lower(line).starts_with(named)) {
    const char separator = line[named.size()];
    if (!next_line(text, line)) fail(text, "the file ends before its header");
    return separator;
  }
  for (const char separator : {',', ';', '\t'}) {
    if (line.find(separator) != line.npos) return separator;
  }
  return ',';
}

Columns read_header(Text& text, std::string_view line) {
  const char separator = separator_of(text, line);
  std::vector<std::string> names = csv_cells(text, line, separator);
  for (std::string& name : names) name = lower(name);
  const auto find = [&](const char* name) { return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin()); };
  Columns columns{{find("x"), find("y"), find("z")}, {}, names.size(), separator};
  if (std::max({columns.position[0], columns.position[1], columns.position[2]}) == names.size()) {
    fail(text, "the header must name the columns x, y and z (and label or name), separated by commas, semicolons or tabs");
  }
  for (const char* name : {"x", "y", "z"}) {
    if (std::count(names.begin(), names.end(), name) > 1) fail(text, fmt::format("the header names the column {} twice; leave one", name));
  }
  for (const char* name : {"name", "label"}) {
    if (find(name) < names.size()) columns.label = find(name);
  }
  return columns;
}

MarkupPoint read_row(Text& text, const std::vector<std::string>& cells, const Columns& columns) {
  if (cells.size() != columns.count) fail(text, fmt::format("{} cells, but the header has {}", cells.size(), columns.count));
  const auto& [x, y, z] = columns.position;
  return {columns.label ? cells[*columns.label] : "", "", landmark_cells(text, {cells[x], cells[y], cells[z]})};
}

using Read = std::vector<MarkupPoint> (*)(const std::string& text, const std::string& file);

Read reader_of(const std::string& extension) {
  if (extension == ".csv") return read_points_csv;
  if (extension == ".json") return read_markups;
  if (extension == ".fcsv") return read_fcsv;
  if (extension == ".pts") return read_pts;
  return nullptr;
}

/// With the line ends of Unix or Windows, as all readers expect them.
std::string text_of(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  refuse_utf16(bytes, path.string());
  std::string text = utf8_text(std::string(without_byte_order_mark(bytes)));
  if (text.find('\n') == text.npos) std::replace(text.begin(), text.end(), '\r', '\n');  // those of old Macs
  return text;
}

void turn_to_ras(std::vector<MarkupPoint>& points) {
  for (MarkupPoint& point : points) {
    if (point.position) point.position->head<2>() *= -1;
  }
}

}  // namespace

std::vector<MarkupPoint> read_points_csv(const std::string& content, const std::string& file) {
  Text text{file, content, 0};
  std::string_view line;
  if (!next_line(text, line)) fail(text, "the file is empty");
  const Columns columns = read_header(text, line);
  std::vector<MarkupPoint> points;
  while (next_line(text, line)) {
    if (line.find_first_not_of(" \t") != line.npos) points.push_back(read_row(text, csv_cells(text, line, columns.separator), columns));
  }
  return points;
}

std::vector<MarkupPoint> read_points(const std::filesystem::path& path, const std::string& specimen, bool ras) {
  const std::string extension = lower_extension(path), file = path.string();
  if (extension == ".tps") return chosen_specimen(read_tps(text_of(path), file), specimen, file).points;
  if (extension == ".txt") return chosen_specimen(read_morphologika(text_of(path), file), specimen, file).points;
  const auto read = reader_of(extension);
  check_file(path);
  if (read == nullptr) {
    throw FileError(fmt::format("{}: points are read from {}; save them as one of these", file, readable_points));
  }
  if (!specimen.empty()) throw FileError(fmt::format("{}: it holds the points of one specimen; leave the specimen out", file));
  std::vector<MarkupPoint> points = read(text_of(path), file);
  if (ras && (read == read_markups || read == read_fcsv)) turn_to_ras(points);
  return points;
}

}  // namespace homolog
