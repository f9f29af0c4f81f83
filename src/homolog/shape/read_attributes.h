// SPDX-License-Identifier: MIT
// Beside read_mesh.h: meshes with what is painted on them.
#pragma once

#include <filesystem>

#include "homolog/shape/attributes.h"
#include "homolog/shape/read_mesh.h"

namespace homolog {

inline constexpr const char* readable_attributes = ".ply, .obj, .gltf and .glb";

/// The mesh as read_mesh() reads it, with what is painted on it: of PLY (read_ply_attributes.h), OBJ (read_obj_attributes.h) or glTF
/// (read_gltf_attributes.h, not welded). Throws FileError, also for other formats and when the file says nothing but the form.
AttributedMesh read_attributes(const std::filesystem::path& path, const ReadLimits& limits = {});

}  // namespace homolog
