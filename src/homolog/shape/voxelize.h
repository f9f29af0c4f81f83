// SPDX-License-Identifier: MIT
// Sec. 4.2: the characteristic function of a solid, as coverage per voxel.
#pragma once

#include <optional>

#include "homolog/shape/mesh.h"
#include "homolog/shape/volume.h"

namespace homolog {

struct Voxels {
  Interior interior;
  double guessed = 0;          ///< share of the inside volume on which the rays of the three axes disagree: 0 for a closed mesh
  double open = 0;             ///< share of the triangles' sides without a neighbour: 0 for a closed mesh
  std::size_t components = 1;  ///< pieces of surface
};

/// Coverage of the mesh's inside (winding number not 0: overlapping shells are a union, reversed shells inside are cavities), with
/// `resolution` voxels, 1 to 2048, along the longest side of its bounding box and one empty voxel around. With `part`, a box in shares
/// (0 to 1) of that bounding box, only what is inside it counts, and the grid covers just that. With `thicken`, a share (0 to 1) of the
/// bounding box's diagonal, what lies within half of it of the surface is inside, too, and the box is thickened_box(). Independent of scale
/// and threads. Throws ShapeError when nothing is inside or coordinates are not finite, ParamError for values out of range.
Voxels voxelize(const Mesh& mesh, int resolution, const std::optional<Box>& part = {}, double thicken = 0);

/// The bounding box of a mesh whose surface is as thick as this share of its diagonal.
Box thickened_box(const Mesh& mesh, double thicken);

}  // namespace homolog
