// SPDX-License-Identifier: MIT
#include "homolog/shape/ply_header.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace homolog {
namespace {

NumberType read_type(Text& text, std::string_view word) {
  static constexpr std::pair<std::string_view, NumberType> types[] = {
      {"char", NumberType::int8},   {"uchar", NumberType::uint8},   {"short", NumberType::int16},     {"ushort", NumberType::uint16},
      {"int", NumberType::int32},   {"uint", NumberType::uint32},   {"float", NumberType::float32},   {"double", NumberType::float64},
      {"int8", NumberType::int8},   {"uint8", NumberType::uint8},   {"int16", NumberType::int16},     {"uint16", NumberType::uint16},
      {"int32", NumberType::int32}, {"uint32", NumberType::uint32}, {"float32", NumberType::float32}, {"float64", NumberType::float64},
  };
  for (const auto& [name, type] : types) {
    if (name == word) return type;
  }
  fail(text, "the header names a type that PLY does not have; the file is damaged");
}

PlyEncoding read_encoding(Text& text, std::string_view line) {
  const std::string_view word = take_word(line);
  if (word == "ascii") return PlyEncoding::ascii;
  if (word == "binary_little_endian") return PlyEncoding::little_endian;
  if (word == "binary_big_endian") return PlyEncoding::big_endian;
  fail(text, "the format is neither ascii nor binary_little_endian nor binary_big_endian");
}

PlyProperty read_property(Text& text, std::string_view line) {
  PlyProperty property{"", NumberType::none, NumberType::none};
  std::string_view word = take_word(line);
  if (word == "list") {
    property.count_type = read_type(text, take_word(line));
    if (property.count_type >= NumberType::float32) fail(text, "the length of a list must have a whole-number type");
    word = take_word(line);
  }
  property.type = read_type(text, word);
  property.name = take_word(line);
  return property;
}

/// Every element takes at least its smallest binary size, or in ascii two characters a property.
void check_counts(const Text& text, const PlyHeader& header) {
  std::size_t left = text.rest.size();
  for (const PlyElement& element : header.elements) {
    std::size_t least = 0;
    for (const PlyProperty& property : element.properties) {
      const NumberType first = property.count_type == NumberType::none ? property.type : property.count_type;
      least += header.encoding == PlyEncoding::ascii ? 2 : bytes_of(first);
    }
    if (least == 0 && element.count > 0) fail(text, fmt::format("element {} has no properties", shown(element.name)));
    if (element.count > 0 && element.count > (left + 1) / least) {  // + 1: the last line of an ascii file may lack its end
      fail(text, fmt::format("{} times element {} is announced, but the file is too short for them; it is truncated or damaged",
                             element.count, shown(element.name)));
    }
    left -= std::min(left, element.count * least);
  }
}

}  // namespace

PlyHeader read_ply_header(Text& text) {
  std::string_view line;
  if (!next_line(text, line) || take_word(line) != "ply") fail(text, "this is not a PLY file (its first line is not 'ply')");
  PlyHeader header{};
  bool has_format = false;
  while (true) {
    if (!next_line(text, line)) fail(text, "the file ends inside its header; it is truncated");
    const std::string_view keyword = take_word(line);
    if (keyword == "end_header") break;
    if (keyword == "comment") header.comments.push_back(rest_of(line));
    if (keyword == "comment" || keyword == "obj_info" || keyword.empty()) continue;
    if (keyword == "format") {
      header.encoding = read_encoding(text, line);
      has_format = true;
    } else if (keyword == "element") {
      PlyElement element{std::string(take_word(line)), 0, {}};
      const long long count = take_integer(text, line, "the number of an element");
      if (count < 0) fail(text, "the number of an element is negative");
      element.count = static_cast<std::size_t>(count);
      header.elements.push_back(std::move(element));
    } else if (keyword == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(read_property(text, line));
    } else {
      fail(text, "the header has a line that PLY does not know; the file is damaged");
    }
  }
  if (!has_format) fail(text, "the header has no format line");
  check_counts(text, header);
  return header;
}

}  // namespace homolog
