// SPDX-License-Identifier: MIT
// Materials, textures and pictures of glTF files.
#pragma once

#include "homolog/shape/gltf_file.h"

namespace homolog {

/// Puts the materials and images of a file into mesh.texturing, with `gltf`; pictures that are not there into mesh.missing. Textures that
/// lie by other UVs than TEXCOORD_0 are taken off their materials and stand in mesh.left_out. Throws FileError.
void read_gltf_materials(const GltfFile& file, const FindOther& find_other, AttributedMesh& mesh);

}  // namespace homolog
