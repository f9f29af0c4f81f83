// SPDX-License-Identifier: MIT
// The faces between the voxels of a solid and those around it, which tell how large its surface will be before it is made.
#pragma once

#include <cstdint>

#include "homolog/shape/thin_cells.h"

namespace homolog {

struct VoxelFaces {
  std::uint64_t inner = 0, outer = 0;  ///< within the grid, and on its border
  std::uint64_t inside = 0;            ///< voxels

  std::uint64_t triangles() const { return 2 * (inner + outer); }  ///< of the surface net: two for each face
};

VoxelFaces voxel_faces(const SolidVoxels& solid);

/// Whether the voxels lie as if each were drawn for itself: neighbours differ as often as any two voxels do. In a shape, however rough or
/// porous, most do not, as there is much inside or much outside of it; even of a ball's skin one voxel thick a third do not.
bool are_scattered(const SolidVoxels& solid, const VoxelFaces& faces);

}  // namespace homolog
