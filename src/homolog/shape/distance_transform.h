// SPDX-License-Identifier: MIT
// Sec. 6.2.3: DT(O'), the exact Euclidean distance to the inside of a solid.
#pragma once

#include "homolog/shape/volume.h"

namespace homolog {

/// Distance of every voxel centre, in world units, to the nearest voxel centre with coverage >= 1/2; 0 inside. A grid without inside gives
/// +inf. Exact, O(voxels): Felzenszwalb & Huttenlocher 2012.
Volume<float> distance_transform(const Interior& interior);

}  // namespace homolog
