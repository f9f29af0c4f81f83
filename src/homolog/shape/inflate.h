// SPDX-License-Identifier: MIT
// Compressed bytes of a file (gzip and zlib), never more than are wanted: a small file cannot fill the memory.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace homolog {

/// Whether these bytes begin as gzip does.
bool is_gzip(std::string_view bytes);

/// The first `wanted` bytes, or all if there are fewer. `file` is the name for messages. Throws FileError for damaged data.
std::string inflate(std::string_view compressed, std::size_t wanted, const std::string& file);

}  // namespace homolog
