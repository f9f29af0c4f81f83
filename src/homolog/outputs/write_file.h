// SPDX-License-Identifier: MIT
// Results appear whole or not at all: written under a temporary name in the same folder, then renamed.
#pragma once

#include <filesystem>
#include <string_view>

namespace homolog {

/// Throws OutputError when the file cannot be written.
void write_file(const std::filesystem::path& path, std::string_view contents);

}  // namespace homolog
