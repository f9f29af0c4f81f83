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

/// Coverage of the mesh's inside, `resolution` voxels along the longest side of its bounding box (or of the part inside `part`, a box in
/// shares of the bounding box). Throws ShapeError when nothing is inside, or when coordinates are not finite.
Voxels voxelize(const Mesh& mesh, int resolution, const std::optional<Box>& part = {});

}  // namespace homolog
