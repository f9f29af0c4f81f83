// SPDX-License-Identifier: MIT
// A mesh with carried attributes as OBJ, its MTL and its pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "homolog/outputs/write_file.h"
#include "homolog/shape/attributes.h"

namespace homolog {

/// `out` with vertices in their order, their colours behind the coordinates as MeshLab and Blender read them, UVs and materials; if there
/// are materials, beside it "STEM.mtl" and every picture that a material has as "STEM.NAME", bytes unchanged. Triangles without a material
/// have `not_carried`. `from` names where they are from.
std::vector<OutputFile> attributes_obj(const AttributedMesh& mesh, const std::filesystem::path& out, const std::string& from);

}  // namespace homolog
