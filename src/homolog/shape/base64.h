// SPDX-License-Identifier: MIT
// Bytes that stand as base64 in a text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace homolog {

/// Decodes until at least `wanted` bytes stand in `bytes` or the text ends, and takes what it used off `text`. Blanks are passed over, and
/// padding may come before the end: pieces that were encoded one by one may follow each other. False for a character that is not base64.
bool decode_base64(std::string_view& text, std::size_t wanted, std::string& bytes);

}  // namespace homolog
