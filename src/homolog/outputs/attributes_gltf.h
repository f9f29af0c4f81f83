// SPDX-License-Identifier: MIT
// A mesh with carried attributes as glTF 2.0.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "homolog/outputs/write_file.h"
#include "homolog/shape/attributes.h"

namespace homolog {

/// `out`, a .glb, or a .gltf and its buffer "STEM.bin": the mesh with normals, colours, UVs, materials (those of a glTF file as they were
/// there), pictures inside, the rig (whose joints neither scale nor shear) in its bind pose, the shape keys, and the animations. The mesh
/// is as it is with the weights of its keys applied, as viewers show it. Vertices keep their order; copies that UV seams need come after
/// them. Triangles without a material have none. What lies in `fields` is not written, nor are pictures of OBJ files that are neither PNG
/// nor JPEG (pictures_left_out()). `from` names where they are from, `name` the mesh; empty: as `out`. Throws OutputError.
std::vector<OutputFile> attributes_gltf(const AttributedMesh& mesh, const std::filesystem::path& out, const std::string& from,
                                        const std::string& name = "");

/// The names of pictures that glTF cannot hold.
std::vector<std::string> pictures_left_out(const Texturing& texturing);

}  // namespace homolog
