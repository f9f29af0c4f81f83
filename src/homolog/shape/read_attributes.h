// SPDX-License-Identifier: MIT
// Beside read_mesh.h: meshes with what is painted on them.
#pragma once

#include <filesystem>

#include "homolog/shape/attributes.h"
#include "homolog/shape/read_mesh.h"

namespace homolog {

inline constexpr const char* readable_attributes = ".ply and .obj";

/// The mesh as read_mesh() reads it, with what is painted on it: of PLY (read_ply_attributes.h) or OBJ (read_obj_attributes.h). Throws
/// FileError, also for other formats and when the file says nothing but the form.
AttributedMesh read_attributes(const std::filesystem::path& path, const ReadLimits& limits = {});

}  // namespace homolog
