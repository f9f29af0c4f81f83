// SPDX-License-Identifier: MIT
// Even samples of a solid's surface with outward normals, taken from the voxels so that the mesh's tessellation does not matter.
#pragma once

#include <vector>

#include "homolog/base/vec.h"
#include "homolog/shape/volume.h"

namespace homolog {

struct SurfaceSample {
  Vec3 position, normal;  ///< world coordinates; unit length, outward
};

/// Up to `count` samples in farthest-point order, so that every prefix is even too.
std::vector<SurfaceSample> sample_surface(const Interior& interior, int count);

std::vector<Vec3> positions_of(const std::vector<SurfaceSample>& samples);

/// Of the box around them along their principal axes, which turn with them; 0 of none.
double diagonal_of(const std::vector<SurfaceSample>& samples);

/// Median distance of a place to the nearest other one; 0 for fewer than two.
double typical_spacing(const std::vector<Vec3>& places);

}  // namespace homolog
