// SPDX-License-Identifier: MIT
#include "homolog/shape/thin_cells.h"

namespace homolog {
namespace {

constexpr int reach = 2;  // cells: from above a voxel that stands on a body into that

bool is_full(const SolidVoxels& solid, int x, int y, int z) {
  for (int corner = 0; corner < 8; ++corner) {
    if (!solid.at(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2 & 1))) return false;
  }
  return true;
}

}  // namespace

bool SolidVoxels::at(int x, int y, int z) const {
  if (x < 0 || y < 0 || z < 0 || x >= size[0] || y >= size[1] || z >= size[2]) return false;
  return inside[(static_cast<std::size_t>(z) * size[1] + y) * size[0] + x];
}

bool is_thin(const SolidVoxels& solid, const std::array<int, 3>& cell) {
  for (int z = cell[2] - reach; z <= cell[2] + reach; ++z) {
    for (int y = cell[1] - reach; y <= cell[1] + reach; ++y) {
      for (int x = cell[0] - reach; x <= cell[0] + reach; ++x) {
        if (is_full(solid, x, y, z)) return false;
      }
    }
  }
  return true;
}

}  // namespace homolog
