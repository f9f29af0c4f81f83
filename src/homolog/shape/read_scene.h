// SPDX-License-Identifier: MIT
// Scene formats by assimp. Its importers crash, hang and eat memory on damaged files, so they are fenced in: only formats that
// tests/cli/mutate.py tries, in a child process, with no file opened outside the folder of the one that was named.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

/// ".fbx" and the like.
const std::vector<std::string>& scene_extensions();

/// All meshes of a scene with the transforms of their nodes applied, equal vertices welded. Throws FileError.
Mesh read_scene(const std::filesystem::path& path);

}  // namespace homolog
