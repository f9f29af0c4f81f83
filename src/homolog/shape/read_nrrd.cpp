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
    const std::string name = lower(line.substr(0, colon));
    add_field(text, fields, name, line.substr(colon + 1));
    if ((name == "data file" || name == "datafile") && word_of(fields, {name}) == "LIST") break;  // names of files follow to the end
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

/// What turns coordinates of the file's space to LPS. Spaces may be written without hyphens; those that name no directions stay, as in ITK.
Eigen::Vector4d lps_of_space(const Text& text, const HeaderFields& fields) {
  if (const HeaderField* dimension = find_field(fields, {"space dimension"}); dimension && whole_number(text, *dimension) != 3)
    fail({text.file, {}, dimension->line}, "a solid needs a space of 3 dimensions; save the volume in one");
  const HeaderField* field = find_field(fields, {"space"});
  if (!field) return Eigen::Vector4d::Ones();
  const std::string given = rest_of(field->text);
  std::string space = lower(given);
  space.erase(std::remove_if(space.begin(), space.end(), [](char c) { return c == '-' || c == ' '; }), space.end());
  if (space == "rightanteriorsuperior" || space == "ras") return {-1, -1, 1, 1};
  if (space == "leftanteriorsuperior" || space == "las") return {1, -1, 1, 1};
  for (const char* name : {"leftposteriorsuperior", "lps", "scannerxyz", "3drighthanded", "3dlefthanded"}) {
    if (space == name) return Eigen::Vector4d::Ones();
  }
  fail({text.file, {}, field->line}, fmt::format("the space '{}' is not read; save the volume in left-posterior-superior, "
                                                 "right-anterior-superior or left-anterior-superior",
                                                 shown(given)));
}

/// Axes and origin from 'space directions' and 'space origin', else from 'spacings'.
Mat4 world_of(const Text& text, const HeaderFields& fields) {
  Mat4 world = Mat4::Identity();
  if (const HeaderField* directions = find_field(fields, {"space directions"})) {
    const std::vector<double> numbers = real_numbers(text, *directions, 9, blanks);
    for (int i = 0; i < 9; ++i) world(i % 3, i / 3) = numbers[static_cast<std::size_t>(i)];
  } else if (const HeaderField* spacings = find_field(fields, {"spacings"})) {
    const std::vector<double> numbers = real_numbers(text, *spacings, 3, blanks);
    for (int axis = 0; axis < 3; ++axis) world(axis, axis) = numbers[static_cast<std::size_t>(axis)];
  }
  if (const HeaderField* origin = find_field(fields, {"space origin"})) {
    const std::vector<double> numbers = real_numbers(text, *origin, 3, blanks);
    for (int axis = 0; axis < 3; ++axis) world(axis, 3) = numbers[static_cast<std::size_t>(axis)];
  }
  if (const HeaderField* mins = find_field(fields, {"axis mins", "axismins"}))
    fail({text.file, {}, mins->line}, "'axis mins' are not read; save the volume with 'space directions' and 'space origin'");
  return lps_of_space(text, fields).asDiagonal() * world;
}

/// An axis of anything but space would pass for a side of the solid.
void check_kinds(const Text& text, const HeaderFields& fields) {
  const HeaderField* kinds = find_field(fields, {"kinds"});
  if (!kinds) return;
  static constexpr std::string_view known[] = {"domain", "space", "none", "???"};
  std::string_view rest = kinds->text;
  for (std::string_view kind = take_word(rest); !kind.empty(); kind = take_word(rest)) {
    if (std::find(std::begin(known), std::end(known), lower(kind)) != std::end(known)) continue;
    fail({text.file, {}, kinds->line},
         fmt::format("an axis of the kind '{}' is not one of space; save the labels alone, as a volume of three axes of space",
                     shown(kind)));
  }
}

StoredVoxels stored_as(const Text& text, const HeaderFields& fields) {
  StoredVoxels stored;
  const std::string encoding = lower(word_of(fields, {"encoding"}));
  stored.compressed = encoding == "gzip" || encoding == "gz";
  if (!stored.compressed && encoding != "raw") {
    fail(text, fmt::format("the encoding '{}' is not read; save the volume as raw or gzip", shown(encoding)));
  }
  if (const HeaderField* skip = find_field(fields, {"line skip"}); skip && whole_number(text, *skip) != 0) {
    fail({text.file, {}, skip->line}, "lines before the voxels are not skipped; save the volume without them");
  }
  if (const HeaderField* skip = find_field(fields, {"byte skip"})) {
    const long long bytes = whole_number(text, *skip);
    if (bytes < -1) fail({text.file, {}, skip->line}, "so many bytes cannot be skipped; the file is damaged");
    (stored.compressed && bytes > 0 ? stored.unpacked_skip : stored.skip) = bytes;
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
  if (whole_number(text, dimension) != 3)
    fail({file, {}, dimension.line}, "a solid needs a volume of 3 dimensions; save the one that is meant alone");
  check_kinds(text, fields);
  RawVolume volume;
  const std::vector<long long> sizes = whole_numbers(text, needed_field(text, fields, "sizes"), 3);
  std::copy(sizes.begin(), sizes.end(), volume.size.begin());
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
