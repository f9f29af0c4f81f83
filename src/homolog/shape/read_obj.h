// SPDX-License-Identifier: MIT
// OBJ files. Not left to assimp, which makes a vertex of every face corner and so loses the file's numbering.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/mesh.h"
#include "homolog/shape/tell.h"

namespace homolog {

/// Whether the first line of content, comments left out, is one of OBJ.
bool is_obj(std::string_view content);

/// The mesh in the text of an OBJ file: its v and f lines, vertices in the file's order; everything else is skipped, of which free-form
/// surfaces are told. `file` is its name for messages. Throws FileError (malformed, a vertex number out of range, non-finite coordinates).
Mesh read_obj(std::string_view content, const std::string& file, const Tell& tell = {});

}  // namespace homolog
