// SPDX-License-Identifier: MIT
// Beside read_ply.h: PLY files without faces.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/point_cloud.h"

namespace homolog {

/// Whether the header announces no faces. Throws FileError when it is damaged.
bool is_ply_cloud(std::string_view content, const std::string& file);

/// The points in the bytes of a PLY file: x, y, z and nx, ny, nz of element vertex, all other properties and elements skipped. Points whose
/// normal is zero or not finite are left out. `file` is its name for messages. Throws FileError, also when no point has a normal.
PointCloud read_ply_cloud(std::string_view content, const std::string& file);

}  // namespace homolog
