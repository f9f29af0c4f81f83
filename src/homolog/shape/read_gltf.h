// SPDX-License-Identifier: MIT
// The form alone that a glTF 2.0 file shows, by the tables of gltf_table.h, which know quantised positions, too; assimp does not.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/attributes.h"

namespace homolog {

/// Whether content is a glTF file, as JSON or binary.
bool is_gltf(std::string_view content);

/// All triangles of the scene that the file shows, where its nodes place them; skinned ones where their joints do, in the pose that the
/// nodes give; shape keys applied by the weights that the file gives. Throws FileError, also for more than `most_triangles`, or three times
/// as many vertices, and for extensions that change where things lie and are not read.
Mesh read_gltf(std::string_view content, const std::string& file, const FindOther& find_other, std::size_t most_triangles);

}  // namespace homolog
