// SPDX-License-Identifier: MIT
#pragma once

#include "homolog/base/read_file.h"

namespace homolog {

/// What a mesh file may have at most; more is refused.
struct ReadLimits {
  std::uint64_t bytes = most_bytes;    ///< also of what is unpacked from it
  std::size_t triangles = 50'000'000;  ///< or points of a cloud
  std::uint64_t voxels = std::uint64_t{1} << 29;
};

}  // namespace homolog
