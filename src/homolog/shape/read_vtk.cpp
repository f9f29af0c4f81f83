// SPDX-License-Identifier: MIT
#include "homolog/shape/read_vtk.h"

#include <fmt/format.h>

#include <utility>

#include "homolog/shape/number_type.h"
#include "homolog/shape/text.h"
#include "homolog/shape/vtk_cells.h"

namespace homolog {
namespace {

constexpr std::string_view first_words = "# vtk DataFile Version ";

/// Where the reader is; numbers as text may stand in any number of lines, binary ones begin behind the line that announces them.
struct Source {
  Text text;
  std::string_view line;
  bool binary;
};

struct Contents {
  std::vector<double> points;
  std::vector<VtkCells> cells;
  bool ras = false;
};

/// The next word, in this line or a later one; empty at the end of the file.
std::string_view next_word(Source& source) {
  std::string_view word = take_word(source.line);
  while (word.empty() && next_line(source.text, source.line)) word = take_word(source.line);
  return word;
}

/// The same of a word of the format, which VTK reads in capitals and small letters alike; in small ones here.
std::string next_keyword(Source& source) { return lower(next_word(source)); }

NumberType take_type(Source& source) {
  static constexpr std::pair<std::string_view, NumberType> types[] = {
      {"char", NumberType::int8},         {"unsigned_char", NumberType::uint8},   {"short", NumberType::int16},
      {"int", NumberType::int32},         {"unsigned_short", NumberType::uint16}, {"unsigned_int", NumberType::uint32},
      {"long", NumberType::int64},        {"unsigned_long", NumberType::uint64},  {"float", NumberType::float32},
      {"double", NumberType::float64},    {"vtkidtype", NumberType::int32},       {"vtktypeint64", NumberType::int64},
      {"vtktypeint32", NumberType::int32}};
  const std::string_view word = take_word(source.line);
  for (const auto& [name, type] : types) {
    if (name == lower(word)) return type;
  }
  fail(source.text, fmt::format("numbers of the type '{}' are not read; save it without them, as PLY, say", shown(word)));
}

/// A number of items that the file, having `bytes` for each, can hold.
std::size_t checked(const Source& source, long long count, std::size_t bytes) {
  const std::size_t left = source.binary ? source.text.rest.size() : (source.line.size() + source.text.rest.size() + 1) / 2;
  if (count < 0 || static_cast<unsigned long long>(count) > left / (source.binary ? bytes : 1)) {
    fail(source.text, fmt::format("{} numbers are announced, but the file is too short for them; it is truncated or damaged", count));
  }
  return static_cast<std::size_t>(count);
}

long long take_count(Source& source, const char* what) {
  constexpr long long most = 1LL << 40;  // so that three times as many are still a number
  const long long count = take_integer(source.text, source.line, what);
  if (count < 0 || count > most) fail(source.text, fmt::format("{} cannot be {}; the file is damaged", what, count));
  return count;
}

double take_ascii(Source& source) {
  while (source.line.find_first_not_of(" \t\r") == std::string_view::npos) {
    if (!next_line(source.text, source.line)) fail(source.text, "the file ends before all numbers; it is truncated");
  }
  return take_number(source.text, source.line, "what stands here");
}

std::vector<double> take_numbers(Source& source, long long announced, NumberType type) {
  const std::size_t size = bytes_of(type), count = checked(source, announced, size);
  std::vector<double> numbers(count);
  for (std::size_t i = 0; i < count; ++i) {
    numbers[i] = source.binary ? stored_number(source.text.rest.data() + i * size, type, std::endian::big) : take_ascii(source);
  }
  if (source.binary) source.text.rest.remove_prefix(count * size);
  return numbers;
}

/// Up to version 4 every cell begins with the number of its corners.
VtkCells split(const Source& source, const std::vector<double>& numbers, long long cells) {
  VtkCells result;
  std::size_t at = 0;
  for (long long i = 0; i < cells; ++i) {
    const double size = at < numbers.size() ? numbers[at++] : -1;
    if (!(size >= 0 && size <= static_cast<double>(numbers.size() - at))) {
      fail(source.text, fmt::format("cell {} does not fit into the numbers that are there; the file is damaged", i));
    }
    const auto corners = numbers.begin() + static_cast<std::ptrdiff_t>(at);
    at += static_cast<std::size_t>(size);
    result.corners.insert(result.corners.end(), corners, numbers.begin() + static_cast<std::ptrdiff_t>(at));
    result.ends.push_back(static_cast<double>(result.corners.size()));
  }
  return result;
}

/// From version 5 on the offsets of all cells stand before all corners.
VtkCells take_offsets_and_corners(Source& source, long long offsets, long long corners) {
  VtkCells cells;
  next_word(source);  // OFFSETS
  cells.ends = take_numbers(source, offsets, take_type(source));
  if (!cells.ends.empty()) cells.ends.erase(cells.ends.begin());  // 0, where the first one begins
  if (next_keyword(source) != "connectivity") fail(source.text, "the word CONNECTIVITY is missing; the file is damaged");
  cells.corners = take_numbers(source, corners, take_type(source));
  return cells;
}

VtkCells take_cells(Source& source) {
  const long long cells = take_count(source, "the number of cells"), numbers = take_count(source, "the number of corners");
  if (lower(source.text.rest.substr(0, 7)) == "offsets") return take_offsets_and_corners(source, cells, numbers);
  return split(source, take_numbers(source, numbers, NumberType::int32), cells);
}

/// Ends with an empty line.
void skip_metadata(Source& source) {
  do {
    source.line.remove_prefix(source.line.size());
  } while (next_line(source.text, source.line) && !source.line.empty());
}

/// A text, as a line or behind its length, whose first two bits tell how many bytes it takes.
std::string_view take_text(Source& source) {
  std::string_view& rest = source.text.rest;
  if (!source.binary && next_line(source.text, source.line)) return std::exchange(source.line, {});
  if (rest.empty()) fail(source.text, "the file ends before all texts; it is truncated");
  const auto first = static_cast<unsigned char>(rest[0]);
  const std::size_t bytes = std::size_t{8} >> (first >> 6);
  std::size_t length = first & 63;
  for (std::size_t i = 1; i < bytes && i < rest.size(); ++i) length = length << 8 | static_cast<unsigned char>(rest[i]);
  if (bytes > rest.size() || length > rest.size() - bytes) fail(source.text, "a text is longer than the file; it is truncated or damaged");
  const std::string_view text = rest.substr(bytes, length);
  rest.remove_prefix(bytes + length);
  return text;
}

/// Values of the whole, such as a time; whether one is SPACE and says RAS, as when a .vtp of 3D Slicer was saved as this.
bool take_field(Source& source) {
  bool ras = false;
  take_word(source.line);  // its name
  const long long arrays = take_count(source, "the number of arrays");
  for (long long i = 0; i < arrays; ++i) {
    std::string_view name = next_word(source);
    if (lower(name) == "metadata") {
      skip_metadata(source);
      name = next_word(source);
    }
    if (name.empty()) fail(source.text, fmt::format("the file ends after {} of {} arrays; it is truncated", i, arrays));
    const long long columns = take_count(source, "the number of columns"), rows = take_count(source, "the number of rows");
    if (rows > 0 && columns > static_cast<long long>(source.text.rest.size()) / rows) {
      fail(source.text, "an array does not fit into the file; it is truncated or damaged");
    }
    if (rest_of(source.line) == "string") {
      source.line = {};
      for (long long k = 0; k < columns * rows; ++k) ras |= take_text(source) == "RAS" && name == "SPACE";
    } else {
      take_numbers(source, columns * rows, take_type(source));
    }
  }
  return ras;
}

Contents take_contents(Source& source) {
  Contents contents;
  for (std::string word = next_keyword(source); !word.empty() && word != "point_data" && word != "cell_data"; word = next_keyword(source)) {
    if (word == "points") {
      const long long points = take_count(source, "the number of points");
      contents.points = take_numbers(source, 3 * points, take_type(source));
    } else if (word == "polygons" || word == "triangle_strips") {
      VtkCells cells = take_cells(source);
      contents.cells.push_back(
          cells_of_type(word == "polygons" ? vtk_polygon : vtk_strip, std::move(cells.corners), std::move(cells.ends)));
    } else if (word == "cells") {
      contents.cells.push_back(take_cells(source));
    } else if (word == "cell_types") {
      const long long cells = take_count(source, "the number of cells");
      std::vector<double> types = take_numbers(source, cells, NumberType::int32);
      if (contents.cells.empty()) fail(source.text, "the types of cells stand before the cells; the file is damaged");
      contents.cells.back().types = std::move(types);
    } else if (word == "vertices" || word == "lines") {
      take_cells(source);
    } else if (word == "field") {
      contents.ras |= take_field(source);
    } else if (word == "metadata") {
      skip_metadata(source);
    } else {
      fail(source.text, fmt::format("'{}' is not a word of polygonal data; the file is damaged", shown(word)));
    }
  }
  return contents;
}

}  // namespace

bool is_vtk(std::string_view content) { return content.starts_with(first_words); }

Mesh read_vtk(std::string_view content, const std::string& file) {
  Source source{{file, content}, {}, false};
  std::string_view title;
  if (!is_vtk(content)) fail(source.text, fmt::format("this is not a VTK file (it does not begin with '{}')", first_words));
  next_line(source.text, title);
  next_line(source.text, title);
  const std::string encoding = next_keyword(source);
  source.binary = encoding == "binary";
  if (!source.binary && encoding != "ascii") fail(source.text, "this line must say ASCII or BINARY; the file is damaged");
  if (next_keyword(source) != "dataset") fail(source.text, "the word DATASET is missing; the file is damaged");
  const std::string_view kind = take_word(source.line);
  if (lower(kind) != "polydata" && lower(kind) != "unstructured_grid") {
    fail(source.text,
         fmt::format("data of the kind {} are not read; save a surface as polygonal data, or labels as NRRD or MetaImage, from "
                     "ParaView, say",
                     shown(kind)));
  }
  const Contents contents = take_contents(source);
  Mesh mesh;
  mesh.ras = contents.ras;
  append_vtk(mesh, contents.points, contents.cells, file);
  return mesh;
}

}  // namespace homolog
