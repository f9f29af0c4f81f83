// SPDX-License-Identifier: MIT
// Beside read_ply.h: what a PLY says of its vertices.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/attributes.h"

namespace homolog {

/// The mesh, its colours (red, green, blue and perhaps alpha; whole numbers are shares of their type's largest one), and every other single
/// property of element vertex as a field but for normals (nx, ny, nz): labels if its type is a whole one, values if not. Throws FileError.
AttributedMesh read_ply_attributes(std::string_view content, const std::string& file);

}  // namespace homolog
