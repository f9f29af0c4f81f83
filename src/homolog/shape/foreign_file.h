// SPDX-License-Identifier: MIT
// Files that are not what they are named, or of formats that are not read: known by how they begin, and refused with what to do instead.
#pragma once

#include <string>
#include <string_view>

namespace homolog {

inline constexpr std::size_t telling_bytes = 4096;  ///< of a file, at most, tell what it is

/// Throws FileError when `start`, the first bytes of a file, are those of a web page, an archive, a picture, text in UTF-16, or a format of
/// another program; some of these are known by `extension` (".usdz", say).
void refuse_foreign(std::string_view start, const std::string& extension, const std::string& file);

/// Throws FileError when `start` begins as text in UTF-16 does.
void refuse_utf16(std::string_view start, const std::string& file);

/// Without the mark that some editors put before UTF-8.
std::string_view without_byte_order_mark(std::string_view content);

}  // namespace homolog
