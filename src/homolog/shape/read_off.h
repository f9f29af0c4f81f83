// SPDX-License-Identifier: MIT
// OFF files. Not left to assimp, which rounds coordinates to float and silently mends vertex numbers that do not exist.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/mesh.h"

namespace homolog {

/// Whether content begins as OFF does, with its word.
bool is_off(std::string_view content);

/// The mesh in the text of an OFF file (also COFF, NOFF, STOFF: colours, normals and texture are skipped), vertices in the file's order.
/// `file` is its name for messages. Throws FileError (truncated, malformed, a vertex number out of range, non-finite coordinates).
Mesh read_off(std::string_view content, const std::string& file);

}  // namespace homolog
