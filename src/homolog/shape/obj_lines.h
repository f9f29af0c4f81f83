// SPDX-License-Identifier: MIT
// Lines and numbers of OBJ and MTL files.
#pragma once

#include <cstdint>
#include <string>

#include "homolog/shape/text.h"

namespace homolog {

/// The next line that is not empty, without its comment; lines that end in a backslash, unless it ends a name, go on in the next one and
/// are put together in `joined`. False at the end of the file.
bool next_whole_line(Text& text, std::string_view& line, std::string& joined);

/// The number of a `what`, such as "vertex", counted from 0: written "7", from 1, or "-1", the last one of `so_far`. Throws FileError.
std::uint32_t obj_number(Text& text, std::string_view word, std::size_t so_far, const char* what);

}  // namespace homolog
