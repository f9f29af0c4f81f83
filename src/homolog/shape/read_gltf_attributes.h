// SPDX-License-Identifier: MIT
// Beside read_scene.h: what a glTF 2.0 file says of its vertices.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/attributes.h"

namespace homolog {

/// All triangles of the scene that the file shows, in the coordinates in which read_mesh() has them, but not welded: skinned ones stand
/// where their joints do in the pose that the nodes give, in which the joints then are bound, and shape keys are applied by their weights.
/// With COLOR_0 (white where a mesh has none), TEXCOORD_0, materials and pictures, JOINTS_n and WEIGHTS_n with the skins, and morph targets
/// (those of one name are one key). What it does not read stands in `left_out`. Throws FileError, also for more than `most_triangles`, or
/// three times as many vertices.
AttributedMesh read_gltf_attributes(std::string_view content, const std::string& file, const FindOther& find_other,
                                    std::size_t most_triangles);

}  // namespace homolog
