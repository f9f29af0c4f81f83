// SPDX-License-Identifier: MIT
#include "homolog/shape/raw_volume.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "homolog/base/errors.h"
#include "homolog/shape/inflate.h"

namespace homolog {
namespace {

constexpr double farthest = 1e90;                                 // of coordinates, so that volumes stay numbers
constexpr std::size_t most_unpacked_skip = std::size_t{1} << 20;  // bytes, which nobody counts among those that are unpacked

}  // namespace

double RawVolume::value(std::size_t voxel) const {
  return slope * stored_number(bytes.data() + voxel * bytes_of(type), type, order) + intercept;
}

void check_header(const RawVolume& volume, const std::string& file, const ReadLimits& limits) {
  std::uint64_t voxels = 1;
  for (const std::int64_t side : volume.size) {
    if (side < 1) throw FileError(fmt::format("{}: a side of the volume has {} voxels; the file is damaged", file, side));
    if (static_cast<std::uint64_t>(side) > limits.voxels / voxels) {
      throw FileError(fmt::format("{}: {} x {} x {} voxels are more than the {} that are read; resample or crop the volume", file,
                                  volume.size[0], volume.size[1], volume.size[2], limits.voxels));
    }
    voxels *= static_cast<std::uint64_t>(side);
  }
  if (voxels > limits.bytes / bytes_of(volume.type)) {
    throw FileError(fmt::format("{}: {} voxels of {} bytes are more than the {} bytes that are read; save labels as numbers of one byte",
                                file, voxels, bytes_of(volume.type), limits.bytes));
  }
  const Mat3 axes = volume.world_from_voxel.topLeftCorner<3, 3>();
  const double lengths = axes.colwise().norm().prod();
  if (!(volume.world_from_voxel.cwiseAbs().maxCoeff() < farthest) || !volume.world_from_voxel.allFinite() ||
      !(std::abs(axes.determinant()) > 1e-6 * lengths)) {
    throw FileError(fmt::format("{}: the voxels' axes in the header do not span space; the file is damaged", file));
  }
  if (!std::isfinite(volume.slope) || !std::isfinite(volume.intercept)) {
    throw FileError(fmt::format("{}: the scale of the values in the header is not a finite number; the file is damaged", file));
  }
}

void check_complete(const RawVolume& volume, const std::string& file) {
  const std::size_t length = volume.voxels() * bytes_of(volume.type);
  if (volume.bytes.size() < length) {
    throw FileError(
        fmt::format("{}: {} bytes of voxels are announced, but {} are there; the file is truncated", file, length, volume.bytes.size()));
  }
}

void take_voxels(RawVolume& volume, std::string_view behind_header, const StoredVoxels& stored, const ReadOther& read_other,
                 const std::string& file) {
  const std::size_t length = volume.voxels() * bytes_of(volume.type);
  std::string other;
  if (!stored.other.empty()) {
    other = read_other(stored.other);
    behind_header = other;
  }
  const bool from_end = stored.skip < 0;
  if (from_end && stored.compressed) throw FileError(fmt::format("{}: compressed voxels cannot be found from the end", file));
  const std::size_t available = behind_header.size();
  const std::size_t first = from_end ? available - std::min(available, length) : static_cast<std::size_t>(stored.skip);
  if (first <= available) behind_header.remove_prefix(first);
  const auto inner = static_cast<std::size_t>(stored.unpacked_skip);
  if (inner > most_unpacked_skip) {
    throw FileError(fmt::format("{}: {} unpacked bytes before the voxels are not skipped; save the volume without them", file, inner));
  }
  volume.bytes = first > available   ? std::string()
                 : stored.compressed ? inflate(behind_header, inner + length, file)
                                     : std::string(behind_header.substr(0, length));
  volume.bytes.erase(0, inner);
  check_complete(volume, file);
}

}  // namespace homolog
