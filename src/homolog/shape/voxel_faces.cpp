// SPDX-License-Identifier: MIT
#include "homolog/shape/voxel_faces.h"

namespace homolog {
namespace {

constexpr double by_chance = 0.95;  // of the faces that chance would make; a million drawn voxels stray by less than a hundredth

}  // namespace

VoxelFaces voxel_faces(const SolidVoxels& solid) {
  const auto [nx, ny, nz] = solid.size;
  const std::size_t row = static_cast<std::size_t>(nx), slice = row * static_cast<std::size_t>(ny);
  VoxelFaces faces;
  std::size_t i = 0;
  for (int z = 0; z < nz; ++z) {
    for (int y = 0; y < ny; ++y) {
      const int border = (y == 0) + (y + 1 == ny) + (z == 0) + (z + 1 == nz);
      for (int x = 0; x < nx; ++x, ++i) {
        const bool here = solid.inside[i];
        faces.inner += x + 1 < nx && solid.inside[i + 1] != here;
        faces.inner += y + 1 < ny && solid.inside[i + row] != here;
        faces.inner += z + 1 < nz && solid.inside[i + slice] != here;
        if (!here) continue;
        faces.outer += static_cast<std::uint64_t>(border + (x == 0) + (x + 1 == nx));
        ++faces.inside;
      }
    }
  }
  return faces;
}

bool are_scattered(const SolidVoxels& solid, const VoxelFaces& faces) {
  const auto all = static_cast<double>(solid.inside.size()), share = static_cast<double>(faces.inside) / all;
  const auto [nx, ny, nz] = solid.size;
  const double neighbours = 3 * all - all / nx - all / ny - all / nz;  // pairs of them
  return static_cast<double>(faces.inner) > by_chance * 2 * share * (1 - share) * neighbours;
}

}  // namespace homolog
