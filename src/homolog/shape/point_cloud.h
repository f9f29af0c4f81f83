// SPDX-License-Identifier: MIT
// Points of a surface with its normals there, as scanners and reconstructions give them, in the file's own coordinates and units.
#pragma once

#include <vector>

#include "homolog/base/vec.h"

namespace homolog {

struct PointCloud {
  std::vector<Vec3> points, normals;  ///< as many of either; normals of any length but zero
};

/// What a refusal says where normals are missing.
inline constexpr const char* without_normals =
    "points without normals do not tell an inside; estimate normals and orient them outward (in MeshLab, CloudCompare or Open3D, say), "
    "or export the surface as a mesh";

}  // namespace homolog
