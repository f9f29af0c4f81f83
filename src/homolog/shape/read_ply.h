// SPDX-License-Identifier: MIT
// PLY files (Turk 1994): ascii, binary little and big endian. Not left to assimp, whose PLY reader crashed or hung on a tenth of 800
// mutated files; here every count is checked against the bytes that are there before memory is asked for.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/mesh.h"

namespace homolog {

/// The mesh in the bytes of a PLY file: x, y, z of element vertex and the list vertex_indices (or vertex_index) of element face;
/// vertices in the file's order, every other element and property skipped. `file` is its name for messages. Throws FileError
/// (truncated, malformed, a vertex number out of range, non-finite coordinates).
Mesh read_ply(std::string_view content, const std::string& file);

}  // namespace homolog
