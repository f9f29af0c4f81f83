// SPDX-License-Identifier: MIT
// Beside read_obj.h: what an OBJ says of its vertices and faces.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/attributes.h"

namespace homolog {

/// The mesh, its UVs (vt), the materials of its faces with their pictures (usemtl, mtllib, map_Kd), and colours where each vertex has six
/// numbers. Files that it names and that are not there stand in `missing`. Throws FileError.
AttributedMesh read_obj_attributes(std::string_view content, const std::string& file, const FindOther& find_other);

}  // namespace homolog
