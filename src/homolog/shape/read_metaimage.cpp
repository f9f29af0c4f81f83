// SPDX-License-Identifier: MIT
#include "homolog/shape/read_metaimage.h"

#include <fmt/format.h>

#include <map>
#include <optional>

#include "homolog/shape/text.h"

namespace homolog {
namespace {

struct Entry {
  std::string_view text;
  std::size_t line;
};

using Entries = std::map<std::string, Entry, std::less<>>;

/// All lines `Key = Value` up to ElementDataFile, which ends the header.
Entries read_entries(Text& text) {
  Entries entries;
  std::string_view line;
  while (next_line(text, line)) {
    const std::string_view whole = line, key = take_word(line);
    if (key.empty()) continue;
    if (take_word(line) != "=") fail(text, fmt::format("'{}' is not of the form 'Key = Value'; the file is damaged", shown(whole)));
    if (!entries.emplace(key, Entry{line, text.line}).second) fail(text, "this key stands twice; the file is damaged");
    if (key == "ElementDataFile") return entries;
  }
  fail(text, "the header ends without ElementDataFile; the file is truncated or not a MetaImage");
}

/// The first of these keys that is there.
std::optional<Entry> find(const Entries& entries, std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys) {
    if (const auto entry = entries.find(key); entry != entries.end()) return entry->second;
  }
  return {};
}

std::string_view word(const Entries& entries, std::initializer_list<std::string_view> keys) {
  const std::optional<Entry> entry = find(entries, keys);
  std::string_view rest = entry ? entry->text : std::string_view();
  return take_word(rest);
}

bool is_true(const Entries& entries, std::initializer_list<std::string_view> keys) {
  const std::string_view value = word(entries, keys);
  return value == "True" || value == "true" || value == "1";
}

long long whole(const Text& text, const Entries& entries, std::string_view key, long long otherwise) {
  const std::optional<Entry> entry = find(entries, {key});
  if (!entry) return otherwise;
  Text at{text.file, {}, entry->line};
  std::string_view rest = entry->text;
  return take_integer(at, rest, "this value");
}

VoxelType type_of(const Text& text, std::string_view name) {
  static constexpr std::pair<std::string_view, VoxelType> types[] = {
      {"MET_CHAR", VoxelType::int8},         {"MET_UCHAR", VoxelType::uint8},   {"MET_SHORT", VoxelType::int16},
      {"MET_USHORT", VoxelType::uint16},     {"MET_INT", VoxelType::int32},     {"MET_UINT", VoxelType::uint32},
      {"MET_LONG", VoxelType::int32},        {"MET_ULONG", VoxelType::uint32},  {"MET_LONG_LONG", VoxelType::int64},
      {"MET_ULONG_LONG", VoxelType::uint64}, {"MET_FLOAT", VoxelType::float32}, {"MET_DOUBLE", VoxelType::float64}};
  for (const auto& [own, type] : types) {
    if (own == name) return type;
  }
  fail(text, fmt::format("the ElementType '{}' is not read; save the volume with whole numbers", shown(name)));
}

/// Every three numbers of the matrix are the direction of an axis.
Mat4 world_of(const Text& text, const Entries& entries) {
  const auto numbers = [&](std::initializer_list<std::string_view> keys, auto& values, int count) {
    const std::optional<Entry> entry = find(entries, keys);
    if (!entry) return;
    Text at{text.file, {}, entry->line};
    std::string_view rest = entry->text;
    for (int i = 0; i < count; ++i) values(i) = take_number(at, rest, "a number of this value");
  };
  Mat3 axes = Mat3::Identity();
  Vec3 spacing = Vec3::Ones(), origin = Vec3::Zero();
  auto matrix = axes.reshaped();
  numbers({"TransformMatrix", "Orientation", "Rotation"}, matrix, 9);
  numbers({"ElementSpacing", "ElementSize"}, spacing, 3);
  numbers({"Offset", "Position", "Origin"}, origin, 3);
  Mat4 world = Mat4::Identity();
  world.topLeftCorner<3, 3>() = axes * spacing.asDiagonal();
  world.topRightCorner<3, 1>() = origin;
  return world;
}

}  // namespace

bool is_metaimage(std::string_view content) { return content.substr(0, 10) == "ObjectType" || content.substr(0, 5) == "NDims"; }

RawVolume read_metaimage(std::string_view content, const std::string& file, std::uint64_t most_voxels, const ReadOther& read_other) {
  Text text{file, content};
  const Entries entries = read_entries(text);
  if (whole(text, entries, "NDims", 0) != 3) fail(text, "a solid needs a volume of 3 dimensions (NDims = 3)");
  if (whole(text, entries, "ElementNumberOfChannels", 1) != 1) fail(text, "its voxels have several channels; save labels, one number each");
  if (find(entries, {"BinaryData"}) && !is_true(entries, {"BinaryData"})) fail(text, "its voxels are text; save them as binary");
  RawVolume volume;
  const std::optional<Entry> size = find(entries, {"DimSize"});
  if (!size) fail(text, "the header lacks DimSize");
  Text at{file, {}, size->line};
  std::string_view rest = size->text;
  for (std::int64_t& side : volume.size) side = take_integer(at, rest, "a side");
  volume.type = type_of(text, word(entries, {"ElementType"}));
  const bool big = is_true(entries, {"BinaryDataByteOrderMSB", "ElementByteOrderMSB"});
  volume.order = big ? std::endian::big : std::endian::little;
  volume.world_from_voxel = world_of(text, entries);
  check_header(volume, file, most_voxels);
  StoredVoxels stored{is_true(entries, {"CompressedData"}), std::string(word(entries, {"ElementDataFile"})),
                      whole(text, entries, "HeaderSize", 0)};
  if (stored.skip < -1) fail(text, "HeaderSize is below -1; the file is damaged");
  if (stored.other == "LIST" || stored.other.find('%') != std::string::npos || stored.other.empty()) {
    fail(text, "the voxels stand in several files, or nowhere; save the volume as one file");
  }
  if (stored.other == "LOCAL") stored.other.clear();
  take_voxels(volume, text.rest, stored, read_other, file);
  return volume;
}

}  // namespace homolog
