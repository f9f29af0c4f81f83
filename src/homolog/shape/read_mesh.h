// SPDX-License-Identifier: MIT
// Reading meshes: PLY by ourselves, strictly (read_ply.cpp says why), every other format by assimp.
#pragma once

#include <filesystem>

#include "homolog/shape/mesh.h"

namespace homolog {

/// Reads OFF, OBJ, PLY, STL, glTF and what else assimp knows. Vertices keep the file's order and numbers where the format has shared
/// vertices; polygons become triangles. Throws FileError (missing, empty, truncated, malformed, non-finite, absurdly large).
Mesh read_mesh(const std::filesystem::path& path);

}  // namespace homolog
