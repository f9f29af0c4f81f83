// SPDX-License-Identifier: MIT
// Reading meshes: OFF, OBJ, PLY and STL by ourselves, strictly (their readers say why), scenes by assimp behind a fence.
#pragma once

#include <filesystem>

#include "homolog/base/read_file.h"
#include "homolog/shape/mesh.h"

namespace homolog {

/// What a mesh file may have at most; more is refused.
struct ReadLimits {
  std::uint64_t bytes = most_bytes;
  std::size_t triangles = 50'000'000;
};

/// Reads OFF, OBJ, PLY, STL, glTF/GLB, 3MF, AC3D, COLLADA, FBX and 3DS. The vertices of OFF, OBJ and PLY keep the file's order and numbers;
/// those of the others are welded where they are exactly equal. Transforms of nodes are applied, polygons become triangles, points and
/// lines are left out. Throws FileError (missing, empty, truncated, malformed, non-finite, beyond the limits).
Mesh read_mesh(const std::filesystem::path& path, const ReadLimits& limits = {});

}  // namespace homolog
