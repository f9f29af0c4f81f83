// SPDX-License-Identifier: MIT
// Input files whole, with errors that say what to do.
#pragma once

#include <filesystem>
#include <string>

namespace homolog {

/// Throws FileError for what is missing, a directory, not a regular file, empty, or absurdly large.
void check_file(const std::filesystem::path& path);

/// All bytes of a file that check_file() accepts. Throws FileError.
std::string read_file(const std::filesystem::path& path);

/// ".ply" of "Bear.PLY".
std::string lower_extension(const std::filesystem::path& path);

}  // namespace homolog
