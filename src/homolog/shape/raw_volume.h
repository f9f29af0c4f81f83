// SPDX-License-Identifier: MIT
// The bytes of a volume file, and what its header says of them. Volume files are read by ourselves: their headers are short, Debian's
// libnifti takes truncated files for whole ones, teem's NRRD reader is unmaintained, and ITK is too heavy for three headers.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "homolog/base/vec.h"
#include "homolog/shape/number_type.h"
#include "homolog/shape/read_limits.h"

namespace homolog {

struct RawVolume {
  std::array<std::int64_t, 3> size{0, 0, 0};
  Mat4 world_from_voxel = Mat4::Identity();  ///< of voxel numbers from 0 (whole numbers: middles of voxels), to the left, behind, up (LPS)
  NumberType type = NumberType::uint8;
  std::endian order = std::endian::little;
  double slope = 1, intercept = 0;  ///< value = slope * number + intercept
  std::string bytes;                ///< of all voxels, x fastest

  std::size_t voxels() const { return static_cast<std::size_t>(size[0] * size[1] * size[2]); }
  double value(std::size_t voxel) const;
};

/// Checks that the header makes sense, `file` being its name for messages, and that its voxels, and their bytes when unpacked, are not too
/// many. Throws FileError.
void check_header(const RawVolume& volume, const std::string& file, const ReadLimits& limits);

/// Checks that the bytes of all voxels are there. Throws FileError.
void check_complete(const RawVolume& volume, const std::string& file);

/// How the voxels stand in the file, after the header or in a file of their own.
struct StoredVoxels {
  bool compressed = false;
  std::string other;               ///< the file that holds them; empty: what follows the header
  std::int64_t skip = 0;           ///< so many bytes of it; -1: all but as many as the voxels take
  std::int64_t unpacked_skip = 0;  ///< so many bytes more, of what is unpacked
};

/// Reads the other file that a header names.
using ReadOther = std::function<std::string(const std::string& name)>;

/// Takes the bytes of the voxels from behind the header or from the other file. Throws FileError when there are too few.
void take_voxels(RawVolume& volume, std::string_view behind_header, const StoredVoxels& stored, const ReadOther& read_other,
                 const std::string& file);

}  // namespace homolog
