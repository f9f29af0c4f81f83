// SPDX-License-Identifier: MIT
// Beside read_ply.h: what a PLY says of its vertices and faces.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/attributes.h"

namespace homolog {

/// The mesh, its colours (red, green, blue and perhaps alpha; whole numbers are shares of their type's largest one), its UVs (of vertices,
/// as different programs call them, or `texcoord` of faces) with the pictures of its comments "TextureFile NAME", of faces with several by
/// their `texnumber`, and every other single property as a field but for normals (nx, ny, nz): labels if its type is a whole one, values if
/// not. What faces say is given to the vertices (ply_faces.h). Throws FileError.
AttributedMesh read_ply_attributes(std::string_view content, const std::string& file, const FindOther& find_other);

}  // namespace homolog
