// SPDX-License-Identifier: MIT
// The surface that a point cloud was taken from. As a mesh it goes the way of every mesh: outputs, transfer and the warning of how open
// it is need nothing of their own.
#pragma once

#include <optional>
#include <string>

#include "homolog/shape/mesh.h"
#include "homolog/shape/point_cloud.h"

namespace homolog {

/// The surface around what the points wind around, open where no point is near. Normals that all face inward are turned. There must be a
/// point. `file` is its name for messages. Throws FileError when the points enclose nothing, their normals disagree, or a few of them lie
/// far from all others. `voxels` are those along the longest side; without, as many as the number of points is worth.
Mesh cloud_surface(PointCloud cloud, const std::string& file, std::optional<int> voxels = {});

}  // namespace homolog
