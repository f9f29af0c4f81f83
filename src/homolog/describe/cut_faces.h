// SPDX-License-Identifier: MIT
// A part cut out by a box has faces and edges that the whole shape has not; they must not be taken for its skin or its features.
#pragma once

#include <vector>

#include "homolog/describe/surface_samples.h"
#include "homolog/salient/salient_point.h"
#include "homolog/shape/mesh.h"

namespace homolog {

/// Drops samples on the faces of `part` that cut through `whole` (both in world coordinates, `spacing` the voxels' width), and salient
/// points of whose ball such a face takes more than about a fifth.
void forget_cut_faces(const Box& part, const Box& whole, double spacing, std::vector<SalientPoint>& points,
                      std::vector<SurfaceSample>& surface);

}  // namespace homolog
