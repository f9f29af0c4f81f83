// SPDX-License-Identifier: MIT
// Scene formats by assimp. Its importers crash, hang and eat memory on damaged files, so they are fenced in: only formats that
// tests/cli/mutate.py tries, in a child process that opens no file.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/mesh.h"
#include "homolog/shape/tell.h"

namespace homolog {

/// "fbx" and the like, by how the content begins, and for 3DS, which begins like others, by the ending (".3ds"); empty for other formats.
std::string scene_format(std::string_view content, const std::string& extension);

/// All meshes of a scene in such a format with the transforms of their nodes applied, equal vertices welded. Hidden ones are read, too, and
/// told where the file is AC3D or COLLADA. Throws FileError.
Mesh read_scene(std::string_view content, const std::string& format, const std::string& file, const Tell& tell = {});

}  // namespace homolog
