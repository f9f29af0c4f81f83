// SPDX-License-Identifier: MIT
#include "homolog/shape/read_metaimage.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "homolog/shape/header_fields.h"

namespace homolog {
namespace {

constexpr std::size_t looked_at = 8000;  // bytes, as MetaIO does

/// All lines `Key = Value`, with blanks or without, up to ElementDataFile, which ends the header.
HeaderFields read_fields(Text& text) {
  HeaderFields fields;
  std::string_view line;
  while (next_line(text, line)) {
    if (line.find_first_not_of(" \t") == line.npos) continue;
    const std::size_t equals = line.find('=');
    if (equals == line.npos) fail(text, fmt::format("'{}' is not of the form 'Key = Value'; the file is damaged", shown(line)));
    const std::string key = rest_of(line.substr(0, equals));
    if (key != "Comment") add_field(text, fields, key, line.substr(equals + 1));  // of these there may be many
    if (key == "ElementDataFile") return fields;
  }
  fail(text, "the header ends without ElementDataFile; the file is truncated or not a MetaImage");
}

/// As MetaIO takes it, by the first letter; what is neither would be false there.
bool is_true(const Text& text, const HeaderFields& fields, std::initializer_list<std::string_view> names) {
  const HeaderField* field = find_field(fields, names);
  if (!field) return false;
  const std::string value = rest_of(field->text);
  const char first = value.empty() ? ' ' : value[0];
  const bool yes = first == 'T' || first == 't' || first == '1';
  if (!yes && first != 'F' && first != 'f' && first != '0')
    fail({text.file, {}, field->line}, fmt::format("'{}' is neither True nor False; the file is damaged", shown(value)));
  return yes;
}

long long whole(const Text& text, const HeaderFields& fields, std::string_view name, long long otherwise) {
  const HeaderField* field = find_field(fields, {name});
  return field ? whole_number(text, *field) : otherwise;
}

NumberType type_of(const Text& text, std::string_view name) {
  static constexpr std::pair<std::string_view, NumberType> types[] = {
      {"MET_CHAR", NumberType::int8},         {"MET_UCHAR", NumberType::uint8},   {"MET_SHORT", NumberType::int16},
      {"MET_USHORT", NumberType::uint16},     {"MET_INT", NumberType::int32},     {"MET_UINT", NumberType::uint32},
      {"MET_LONG", NumberType::int32},        {"MET_ULONG", NumberType::uint32},  {"MET_LONG_LONG", NumberType::int64},
      {"MET_ULONG_LONG", NumberType::uint64}, {"MET_FLOAT", NumberType::float32}, {"MET_DOUBLE", NumberType::float64}};
  for (const auto& [own, type] : types) {
    if (own == name) return type;
  }
  fail(text, fmt::format("the ElementType '{}' is not read; save the volume with whole numbers", shown(name)));
}

/// Every three numbers of the matrix are the direction of an axis.
Mat4 world_of(const Text& text, const HeaderFields& fields) {
  const auto take = [&](std::initializer_list<std::string_view> names, auto& values, int count) {
    const HeaderField* field = find_field(fields, names);
    if (!field) return;
    const std::vector<double> numbers = real_numbers(text, *field, static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) values(i) = numbers[static_cast<std::size_t>(i)];
  };
  Mat3 axes = Mat3::Identity();
  Vec3 spacing = Vec3::Ones(), origin = Vec3::Zero();
  auto matrix = axes.reshaped();
  take({"TransformMatrix", "Orientation", "Rotation"}, matrix, 9);
  take({"ElementSpacing", "ElementSize"}, spacing, 3);
  if (!(spacing.minCoeff() > 0)) fail(text, "a spacing is not positive; save it with sides that are, and mirror it by TransformMatrix");
  take({"Offset", "Position", "Origin"}, origin, 3);
  Mat4 world = Mat4::Identity();
  world.topLeftCorner<3, 3>() = axes * spacing.asDiagonal();
  world.topRightCorner<3, 1>() = origin;
  return world;
}

}  // namespace

bool is_metaimage(std::string_view content) {
  Text text{{}, content.substr(0, looked_at)};
  std::string_view line;
  while (next_line(text, line) && line.starts_with("Comment")) continue;
  return line.starts_with("ObjectType") || line.starts_with("NDims");
}

RawVolume read_metaimage(std::string_view content, const std::string& file, const ReadLimits& limits, const ReadOther& read_other) {
  Text text{file, content};
  const HeaderFields fields = read_fields(text);
  if (whole(text, fields, "NDims", 0) != 3) fail(text, "a solid needs a volume of 3 dimensions (NDims = 3)");
  if (whole(text, fields, "ElementNumberOfChannels", 1) != 1) fail(text, "its voxels have several channels; save labels, one number each");
  if (find_field(fields, {"BinaryData"}) && !is_true(text, fields, {"BinaryData"})) fail(text, "its voxels are text; save them as binary");
  RawVolume volume;
  const std::vector<long long> sizes = whole_numbers(text, needed_field(text, fields, "DimSize"), 3);
  std::copy(sizes.begin(), sizes.end(), volume.size.begin());
  volume.type = type_of(text, word_of(fields, {"ElementType"}));
  const bool big = is_true(text, fields, {"BinaryDataByteOrderMSB", "ElementByteOrderMSB"});
  volume.order = big ? std::endian::big : std::endian::little;
  volume.world_from_voxel = world_of(text, fields);
  check_header(volume, file, limits);
  StoredVoxels stored{is_true(text, fields, {"CompressedData"}), other_file(text, fields, {"ElementDataFile"}),
                      whole(text, fields, "HeaderSize", 0)};
  if (stored.skip < -1) fail(text, "HeaderSize is below -1; the file is damaged");
  if (stored.other.empty()) fail(text, "ElementDataFile does not say where the voxels are; the file is damaged");
  if (lower(stored.other) == "local") stored.other.clear();
  take_voxels(volume, text.rest, stored, read_other, file);
  return volume;
}

}  // namespace homolog
