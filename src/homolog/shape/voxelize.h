// SPDX-License-Identifier: MIT
// Sec. 4.2: the characteristic function of a solid, as coverage per voxel.
#pragma once

#include <optional>

#include "homolog/shape/mesh.h"
#include "homolog/shape/volume.h"

namespace homolog {

struct Voxels {
  Interior interior;
  double guessed = 0;  ///< share of the inside volume on which the rays of the three axes disagree: 0 for a closed mesh
};

/// Coverage of the mesh's inside (winding number not 0: overlapping shells are a union, reversed shells inside are cavities), with
/// `resolution` voxels, 1 to 2048, along the longest side of its bounding box and one empty voxel around. With `part`, a box in shares
/// (0 to 1) of that bounding box, only what is inside it counts, and the grid covers just that. Independent of scale and threads.
/// Throws ShapeError when nothing is inside or coordinates are not finite, ParamError for values out of range.
Voxels voxelize(const Mesh& mesh, int resolution, const std::optional<Box>& part = {});

}  // namespace homolog
