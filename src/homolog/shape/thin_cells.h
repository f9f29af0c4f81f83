// SPDX-License-Identifier: MIT
// Where a solid of voxels is so thin that smoothing its surface would take it away.
#pragma once

#include <array>
#include <vector>

namespace homolog {

/// Which voxels of a grid are inside, x fastest; outside the grid none is.
struct SolidVoxels {
  std::array<int, 3> size;
  std::vector<bool> inside;

  bool at(int x, int y, int z) const;
};

/// Is the solid one voxel thick around the cell between the voxels from `cell` to `cell` + 1? Then no eight voxels between which a cell
/// lies, up to two cells away, are all inside: a single voxel that stands on a body is not thin, a rod of one by one is.
bool is_thin(const SolidVoxels& solid, const std::array<int, 3>& cell);

}  // namespace homolog
