// SPDX-License-Identifier: MIT
// 3MF (3D Manufacturing Format, core and production extension), as modellers and slicers write it. Ours, on minizip and expat: assimp
// crashes on damaged archives and reads no objects in other parts of them, where slicers put them; lib3mf brings libzip and OpenSSL along.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/mesh.h"
#include "homolog/shape/read_limits.h"
#include "homolog/shape/tell.h"

namespace homolog {

/// Is this a zip archive with such a model in it?
bool is_3mf(std::string_view content);

/// The meshes of all objects that are built, moved as the file says, but supports and objects that are not printed, and beams, which are
/// told. Units are left alone. Throws FileError for what is missing, names a part or a vertex that does not exist, is not finite, or beyond
/// the limits.
Mesh read_3mf(std::string_view content, const std::string& file, const ReadLimits& limits, const Tell& tell = {});

}  // namespace homolog
