// SPDX-License-Identifier: MIT
// Input files whole, with errors that say what to do.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace homolog {

inline constexpr std::uint64_t most_bytes = std::uint64_t{2} << 30;  ///< of a file, unless more are allowed

/// Throws FileError for what is missing, a directory, not a regular file, empty, or larger than `most` bytes.
void check_file(const std::filesystem::path& path, std::uint64_t most = most_bytes);

/// All bytes of a file that check_file() accepts. Throws FileError.
std::string read_file(const std::filesystem::path& path, std::uint64_t most = most_bytes);

/// ".ply" of "Bear.PLY".
std::string lower_extension(const std::filesystem::path& path);

}  // namespace homolog
