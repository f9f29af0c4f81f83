// SPDX-License-Identifier: MIT
#include "homolog/shape/read_nrrd.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "homolog/shape/header_fields.h"

namespace homolog {
namespace {

constexpr std::string_view blanks = "(),";  // around and between numbers

HeaderFields read_fields(Text& text) {
  HeaderFields fields;
  std::string_view line;
  while (next_line(text, line) && !line.empty()) {
    const std::size_t colon = line.find(':');
    if (line[0] == '#') continue;
    if (colon == std::string_view::npos || colon + 1 >= line.size())
      fail(text, "this line of the header has no field; the file is damaged");
    if (line[colon + 1] == '=') continue;  // a key of the user's own
    add_field(text, fields, lower(line.substr(0, colon)), line.substr(colon + 1));
  }
  return fields;
}

NumberType type_of(const Text& text, const HeaderField& field) {
  static const std::pair<NumberType, std::vector<std::string_view>> types[] = {
      {NumberType::int8, {"signed char", "int8", "int8_t"}},
      {NumberType::uint8, {"uchar", "unsigned char", "uint8", "uint8_t"}},
      {NumberType::int16, {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
      {NumberType::uint16, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
      {NumberType::int32, {"int", "signed int", "int32", "int32_t"}},
      {NumberType::uint32, {"uint", "unsigned int", "uint32", "uint32_t"}},
      {NumberType::int64, {"longlong", "long long", "long long int", "signed long long", "signed long long int", "int64", "int64_t"}},
      {NumberType::uint64, {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}},
      {NumberType::float32, {"float"}},
      {NumberType::float64, {"double"}}};
  const std::string name = lower(rest_of(field.text));
  for (const auto& [type, names] : types) {
    if (std::find(names.begin(), names.end(), name) != names.end()) return type;
  }
  fail({text.file, {}, field.line}, fmt::format("the type '{}' is not read; save the volume with whole numbers", shown(name)));
}

/// Axes and origin from 'space directions' and 'space origin', else from 'spacings'.
Mat4 world_of(const Text& text, const HeaderFields& fields) {
  Mat4 world = Mat4::Identity();
  if (const HeaderField* directions = find_field(fields, {"space directions"})) {
    FieldNumbers numbers(text, *directions, blanks);
    for (int i = 0; i < 9; ++i) world(i % 3, i / 3) = numbers.real();
  } else if (const HeaderField* spacings = find_field(fields, {"spacings"})) {
    FieldNumbers numbers(text, *spacings, blanks);
    for (int axis = 0; axis < 3; ++axis) world(axis, axis) = numbers.real();
  }
  if (const HeaderField* origin = find_field(fields, {"space origin"})) {
    FieldNumbers numbers(text, *origin, blanks);
    for (int axis = 0; axis < 3; ++axis) world(axis, 3) = numbers.real();
  }
  if (const HeaderField* mins = find_field(fields, {"axis mins", "axismins"}))
    fail({text.file, {}, mins->line}, "'axis mins' are not read; save the volume with 'space directions' and 'space origin'");
  const std::string space = lower(word_of(fields, {"space"}));
  if (space == "right-anterior-superior" || space == "ras") return Eigen::Vector4d(-1, -1, 1, 1).asDiagonal() * world;
  if (space == "left-anterior-superior" || space == "las") return Eigen::Vector4d(1, -1, 1, 1).asDiagonal() * world;
  return world;
}

StoredVoxels stored_as(const Text& text, const HeaderFields& fields) {
  StoredVoxels stored;
  const std::string encoding = lower(word_of(fields, {"encoding"}));
  stored.compressed = encoding == "gzip" || encoding == "gz";
  if (!stored.compressed && encoding != "raw") {
    fail(text, fmt::format("the encoding '{}' is not read; save the volume as raw or gzip", shown(encoding)));
  }
  if (const HeaderField* skip = find_field(fields, {"line skip"}); skip && FieldNumbers(text, *skip, blanks).whole() != 0) {
    fail({text.file, {}, skip->line}, "lines before the voxels are not skipped; save the volume without them");
  }
  if (const HeaderField* skip = find_field(fields, {"byte skip"})) {
    stored.skip = FieldNumbers(text, *skip, blanks).whole();
    if (stored.skip < -1) fail({text.file, {}, skip->line}, "so many bytes cannot be skipped; the file is damaged");
  }
  stored.other = other_file(text, fields, {"data file", "datafile"});
  return stored;
}

}  // namespace

bool is_nrrd(std::string_view content) { return content.substr(0, 7) == "NRRD000"; }

RawVolume read_nrrd(std::string_view content, const std::string& file, const ReadLimits& limits, const ReadOther& read_other) {
  Text text{file, content};
  std::string_view line;
  if (!is_nrrd(content) || !next_line(text, line)) fail(text, "this is not a NRRD file (its first line is not 'NRRD000')");
  const HeaderFields fields = read_fields(text);
  const HeaderField& dimension = needed_field(text, fields, "dimension");
  if (FieldNumbers(text, dimension, blanks).whole() != 3)
    fail({file, {}, dimension.line}, "a solid needs a volume of 3 dimensions; save the one that is meant alone");
  RawVolume volume;
  FieldNumbers sizes(text, needed_field(text, fields, "sizes"), blanks);
  for (std::int64_t& side : volume.size) side = sizes.whole();
  volume.type = type_of(text, needed_field(text, fields, "type"));
  const std::string order = lower(word_of(fields, {"endian"}));
  volume.order = order == "big" ? std::endian::big : std::endian::little;
  if (bytes_of(volume.type) > 1 && volume.order == std::endian::little && order != "little") {
    fail(text, "the header does not say 'endian: little' or 'endian: big'");
  }
  volume.world_from_voxel = world_of(text, fields);
  check_header(volume, file, limits);
  take_voxels(volume, text.rest, stored_as(text, fields), read_other, file);
  return volume;
}

}  // namespace homolog
