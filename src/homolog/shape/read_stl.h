// SPDX-License-Identifier: MIT
// STL files, text and binary. Not left to assimp, which takes truncated text files for whole ones.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/mesh.h"

namespace homolog {

/// Whether content begins as STL does, as text or with the size that binary STL announces.
bool is_stl(std::string_view content);

/// The mesh in the bytes of an STL file, welded while it is read, for the file holds every vertex some six times. `file` is its name for
/// messages. Throws FileError (truncated, malformed, non-finite coordinates).
Mesh read_stl(std::string_view content, const std::string& file);

}  // namespace homolog
