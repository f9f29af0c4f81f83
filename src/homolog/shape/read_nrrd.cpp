// SPDX-License-Identifier: MIT
#include "homolog/shape/read_nrrd.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "homolog/shape/text.h"

namespace homolog {
namespace {

/// What stands behind the field's name, and in which line.
struct Field {
  std::string_view text;
  std::size_t line;
};

using Fields = std::map<std::string, Field, std::less<>>;

Fields read_fields(Text& text) {
  Fields fields;
  std::string_view line;
  while (next_line(text, line) && !line.empty()) {
    const std::size_t colon = line.find(':');
    if (line[0] == '#') continue;
    if (colon == std::string_view::npos || colon + 1 >= line.size())
      fail(text, "this line of the header has no field; the file is damaged");
    if (line[colon + 1] == '=') continue;  // a key of the user's own
    std::string name(line.substr(0, colon));
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    if (!fields.emplace(name, Field{line.substr(colon + 1), text.line}).second) fail(text, "this field stands twice; the file is damaged");
  }
  return fields;
}

std::string_view word_of(const Fields& fields, std::string_view name) {
  const auto field = fields.find(name);
  std::string_view rest = field == fields.end() ? std::string_view() : field->second.text;
  return take_word(rest);
}

/// The field's text to take numbers from, with messages at its line. Brackets and commas are blanks.
struct Numbers {
  Text text;
  std::string blanked;
  std::string_view rest;

  Numbers(const Text& at, const Field& field) : text{at.file, {}, field.line}, blanked(field.text) {
    for (char& c : blanked) c = c == '(' || c == ')' || c == ',' ? ' ' : c;
    rest = blanked;
  }
  double real() { return take_number(text, rest, "a number of this field"); }
  long long whole() { return take_integer(text, rest, "a number of this field"); }
};

const Field& needed(const Text& text, const Fields& fields, std::string_view name) {
  const auto field = fields.find(name);
  if (field == fields.end()) fail(text, fmt::format("the header lacks the field '{}'", name));
  return field->second;
}

VoxelType type_of(const Text& text, const Field& field) {
  static constexpr std::pair<std::string_view, VoxelType> types[] = {
      {"signed char", VoxelType::int8},    {"int8", VoxelType::int8},           {"int8_t", VoxelType::int8},
      {"uchar", VoxelType::uint8},         {"unsigned char", VoxelType::uint8}, {"uint8", VoxelType::uint8},
      {"uint8_t", VoxelType::uint8},       {"short", VoxelType::int16},         {"int16", VoxelType::int16},
      {"int16_t", VoxelType::int16},       {"ushort", VoxelType::uint16},       {"unsigned short", VoxelType::uint16},
      {"uint16", VoxelType::uint16},       {"uint16_t", VoxelType::uint16},     {"int", VoxelType::int32},
      {"int32", VoxelType::int32},         {"int32_t", VoxelType::int32},       {"uint", VoxelType::uint32},
      {"unsigned int", VoxelType::uint32}, {"uint32", VoxelType::uint32},       {"uint32_t", VoxelType::uint32},
      {"longlong", VoxelType::int64},      {"int64", VoxelType::int64},         {"int64_t", VoxelType::int64},
      {"ulonglong", VoxelType::uint64},    {"uint64", VoxelType::uint64},       {"uint64_t", VoxelType::uint64},
      {"float", VoxelType::float32},       {"double", VoxelType::float64}};
  std::string_view name = field.text;
  while (!name.empty() && name.front() == ' ') name.remove_prefix(1);
  while (!name.empty() && (name.back() == ' ' || name.back() == '\t')) name.remove_suffix(1);
  for (const auto& [word, type] : types) {
    if (word == name) return type;
  }
  fail({text.file, {}, field.line}, fmt::format("the type '{}' is not read; save the volume with whole numbers", shown(name)));
}

/// Axes and origin from 'space directions' and 'space origin', else from 'spacings'.
Mat4 world_of(const Text& text, const Fields& fields) {
  Mat4 world = Mat4::Identity();
  if (const auto directions = fields.find("space directions"); directions != fields.end()) {
    Numbers numbers(text, directions->second);
    for (int i = 0; i < 9; ++i) world(i % 3, i / 3) = numbers.real();
  } else if (const auto spacings = fields.find("spacings"); spacings != fields.end()) {
    Numbers numbers(text, spacings->second);
    for (int axis = 0; axis < 3; ++axis) world(axis, axis) = numbers.real();
  }
  if (const auto origin = fields.find("space origin"); origin != fields.end()) {
    Numbers numbers(text, origin->second);
    for (int axis = 0; axis < 3; ++axis) world(axis, 3) = numbers.real();
  }
  const std::string_view space = word_of(fields, "space");
  if (space == "right-anterior-superior" || space == "RAS") return Eigen::Vector4d(-1, -1, 1, 1).asDiagonal() * world;
  if (space == "left-anterior-superior" || space == "LAS") return Eigen::Vector4d(1, -1, 1, 1).asDiagonal() * world;
  return world;
}

StoredVoxels stored_as(const Text& text, const Fields& fields) {
  StoredVoxels stored;
  const std::string_view encoding = word_of(fields, "encoding");
  stored.compressed = encoding == "gzip" || encoding == "gz";
  if (!stored.compressed && encoding != "raw") {
    fail(text, fmt::format("the encoding '{}' is not read; save the volume as raw or gzip", shown(encoding)));
  }
  if (const auto skip = fields.find("line skip"); skip != fields.end() && Numbers(text, skip->second).whole() != 0) {
    fail({text.file, {}, skip->second.line}, "lines before the voxels are not skipped; save the volume without them");
  }
  if (const auto skip = fields.find("byte skip"); skip != fields.end()) {
    stored.skip = Numbers(text, skip->second).whole();
    if (stored.skip < -1) fail({text.file, {}, skip->second.line}, "so many bytes cannot be skipped; the file is damaged");
  }
  for (const char* name : {"data file", "datafile"}) {
    if (const std::string_view other = word_of(fields, name); !other.empty()) stored.other = std::string(other);
  }
  if (stored.other == "LIST" || stored.other.find('%') != std::string::npos) {
    fail(text, "the voxels stand in several files; save the volume as one");
  }
  return stored;
}

}  // namespace

bool is_nrrd(std::string_view content) { return content.substr(0, 7) == "NRRD000"; }

RawVolume read_nrrd(std::string_view content, const std::string& file, std::uint64_t most_voxels, const ReadOther& read_other) {
  Text text{file, content};
  std::string_view line;
  if (!is_nrrd(content) || !next_line(text, line)) fail(text, "this is not a NRRD file (its first line is not 'NRRD000')");
  const Fields fields = read_fields(text);
  Numbers dimension(text, needed(text, fields, "dimension"));
  if (dimension.whole() != 3) fail(dimension.text, "a solid needs a volume of 3 dimensions; save the one that is meant alone");
  RawVolume volume;
  Numbers sizes(text, needed(text, fields, "sizes"));
  for (std::int64_t& side : volume.size) side = sizes.whole();
  volume.type = type_of(text, needed(text, fields, "type"));
  volume.order = word_of(fields, "endian") == "big" ? std::endian::big : std::endian::little;
  if (bytes_of(volume.type) > 1 && volume.order == std::endian::little && word_of(fields, "endian") != "little") {
    fail(text, "the header does not say 'endian: little' or 'endian: big'");
  }
  volume.world_from_voxel = world_of(text, fields);
  check_header(volume, file, most_voxels);
  take_voxels(volume, text.rest, stored_as(text, fields), read_other, file);
  return volume;
}

}  // namespace homolog
