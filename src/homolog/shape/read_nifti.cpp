// SPDX-License-Identifier: MIT
#include "homolog/shape/read_nifti.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "homolog/base/errors.h"
#include "homolog/shape/inflate.h"

namespace homolog {
namespace {

/// Where the fields of the two versions stand; those of version 2 are twice as wide.
struct Layout {
  std::size_t header, magic, dim, datatype, pixdim, offset, slope, intercept, qform, sform, quaternion, shift, rows;
  bool wide;
};

constexpr std::size_t extender = 4;      // bytes behind the header, the first of which tells whether extensions follow
constexpr double rounding = 3 * 1.2e-7;  // of squares of floats, as nibabel allows

constexpr Layout version1{348, 344, 40, 70, 76, 108, 112, 116, 252, 254, 256, 268, 280, false};
constexpr Layout version2{540, 4, 16, 12, 104, 168, 176, 184, 344, 348, 352, 376, 400, true};

template <class T>
T field(std::string_view header, std::size_t at, std::endian order) {
  char buffer[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i) buffer[i] = header[at + (order == std::endian::native ? i : sizeof(T) - 1 - i)];
  T value;
  std::memcpy(&value, buffer, sizeof(T));
  return value;
}

struct Header {
  std::string_view bytes;
  const Layout* layout = nullptr;
  std::endian order = std::endian::little;

  double real(std::size_t at, std::size_t number) const {
    return layout->wide ? field<double>(bytes, at + 8 * number, order) : field<float>(bytes, at + 4 * number, order);
  }
  std::int64_t dim(std::size_t number) const {
    return layout->wide ? field<std::int64_t>(bytes, layout->dim + 8 * number, order)
                        : field<std::int16_t>(bytes, layout->dim + 2 * number, order);
  }
  int code(std::size_t at) const { return layout->wide ? field<std::int32_t>(bytes, at, order) : field<std::int16_t>(bytes, at, order); }
};

/// The layout is that whose length the header begins with, in either byte order; null if none.
Header find_layout(std::string_view bytes) {
  for (const Layout* layout : {&version1, &version2}) {
    if (bytes.size() < layout->header) continue;
    for (const std::endian order : {std::endian::little, std::endian::big}) {
      if (field<std::int32_t>(bytes, 0, order) == static_cast<std::int32_t>(layout->header)) return {bytes, layout, order};
    }
  }
  return {};
}

NumberType type_of(int code, const std::string& file) {
  static constexpr std::pair<int, NumberType> types[] = {
      {2, NumberType::uint8},  {4, NumberType::int16},    {8, NumberType::int32},    {16, NumberType::float32}, {64, NumberType::float64},
      {256, NumberType::int8}, {512, NumberType::uint16}, {768, NumberType::uint32}, {1024, NumberType::int64}, {1280, NumberType::uint64}};
  for (const auto& [number, type] : types) {
    if (number == code) return type;
  }
  throw FileError(fmt::format("{}: values of NIfTI type {} are no labels; save the volume with whole numbers", file, code));
}

/// Of the axis from 0. Other readers take sizes below 0 for mirrored axes or for their magnitudes.
double voxel_size(const Header& header, int axis, const std::string& file) {
  const double size = header.real(header.layout->pixdim, static_cast<std::size_t>(axis) + 1);
  if (!(size > 0)) throw FileError(fmt::format("{}: a size of voxels in the header is {}, not above 0; the file is damaged", file, size));
  return size;
}

Mat4 qform_of(const Header& header, const std::string& file) {
  const Layout& layout = *header.layout;
  const double b = header.real(layout.quaternion, 0), c = header.real(layout.quaternion, 1), d = header.real(layout.quaternion, 2);
  const double rest = 1 - (b * b + c * c + d * d);
  if (rest < -rounding) {
    throw FileError(fmt::format("{}: the quaternion in the header is longer than 1; the file is damaged", file));
  }
  const double a = std::sqrt(std::max(0.0, rest));
  Mat4 world = Mat4::Identity();
  world.topLeftCorner<3, 3>() = Eigen::Quaterniond(a, b, c, d).normalized().toRotationMatrix();  // three may be too long, as rounded
  for (int axis = 0; axis < 3; ++axis) {
    world.col(axis) *= voxel_size(header, axis, file);
    world(axis, 3) = header.real(layout.shift, static_cast<std::size_t>(axis));
  }
  if (header.real(layout.pixdim, 0) < 0) world.col(2) *= -1;
  return world;
}

/// To the right, before, up (RAS), as the header has it. Where it has nothing but sizes ("method 1") the standard knows no directions.
Mat4 world_of(const Header& header, const std::string& file) {
  const Layout& layout = *header.layout;
  Mat4 world = Mat4::Identity();
  if (header.code(layout.sform) > 0) {
    for (int i = 0; i < 12; ++i) world(i / 4, i % 4) = header.real(layout.rows, static_cast<std::size_t>(i));
    return world;
  }
  if (header.code(layout.qform) > 0) return qform_of(header, file);
  for (int axis = 0; axis < 3; ++axis) world(axis, axis) = voxel_size(header, axis, file);
  return world;
}

void check_dimensions(const Header& header, const std::string& file) {
  const std::int64_t dimensions = header.dim(0);
  if (dimensions < 3 || dimensions > 7) {
    throw FileError(fmt::format("{}: it has {} dimensions, but a solid needs a volume of 3", file, dimensions));
  }
  for (std::size_t i = 4; i <= static_cast<std::size_t>(dimensions); ++i) {
    if (header.dim(i) > 1) throw FileError(fmt::format("{}: it holds {} volumes; save the one that is meant alone", file, header.dim(i)));
  }
}

/// The byte at which the voxels begin: 0 stands for the first place where they may, if there are no extensions before them.
std::size_t first_voxel(const Header& header, const std::string& file) {
  const Layout& layout = *header.layout;
  const double offset =
      layout.wide ? static_cast<double>(field<std::int64_t>(header.bytes, layout.offset, header.order)) : header.real(layout.offset, 0);
  const bool extended = header.bytes.size() > layout.header && header.bytes[layout.header] != 0;
  if (offset == 0 && !extended) return layout.header + extender;
  if (!(offset >= static_cast<double>(layout.header) && offset <= 1e6)) {
    throw FileError(fmt::format("{}: the voxels begin at byte {}, which is no place for them; the file is damaged", file, offset));
  }
  return static_cast<std::size_t>(offset);
}

/// The bytes of the header and of what tells whether extensions follow.
std::string begin_of(std::string_view content, const std::string& file) {
  constexpr std::size_t most = version2.header + extender;
  return is_gzip(content) ? inflate(content, most, file) : std::string(content.substr(0, most));
}

}  // namespace

bool is_nifti(std::string_view content, const std::string& file) {
  const std::string begin = begin_of(content, file);
  const Header header = find_layout(begin);
  return header.layout && (begin.substr(header.layout->magic, 2) == "n+" || begin.substr(header.layout->magic, 2) == "ni");
}

RawVolume read_nifti(std::string_view content, const std::string& file, const ReadLimits& limits) {
  const bool compressed = is_gzip(content);
  const std::string begin = begin_of(content, file);
  const Header header = find_layout(begin);
  if (!header.layout) throw FileError(fmt::format("{}: this is not a NIfTI file, or its header is truncated", file));
  const Layout& layout = *header.layout;
  if (begin.substr(layout.magic, 2) != "n+") {
    throw FileError(fmt::format("{}: header and voxels stand in two files (.hdr, .img); save them as one .nii", file));
  }
  check_dimensions(header, file);
  RawVolume volume;
  for (std::size_t axis = 0; axis < 3; ++axis) volume.size[axis] = header.dim(axis + 1);
  volume.world_from_voxel = Eigen::Vector4d(-1, -1, 1, 1).asDiagonal() * world_of(header, file);  // LPS
  volume.type = type_of(field<std::int16_t>(begin, layout.datatype, header.order), file);
  volume.order = header.order;
  const double slope = header.real(layout.slope, 0), intercept = header.real(layout.intercept, 0);
  if (std::isfinite(slope) && std::isfinite(intercept) && slope != 0) {  // else the values are the numbers, as programs mean it
    volume.slope = slope;
    volume.intercept = intercept;
  }
  check_header(volume, file, limits);
  const std::size_t first = first_voxel(header, file), length = volume.voxels() * bytes_of(volume.type);
  volume.bytes = compressed ? inflate(content, first + length, file) : std::string(content.substr(0, first + length));
  volume.bytes.erase(0, first);
  check_complete(volume, file);
  return volume;
}

}  // namespace homolog
