// SPDX-License-Identifier: MIT
// Results appear whole or not at all: written under temporary names in the same folder, then renamed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace homolog {

struct OutputFile {
  std::filesystem::path path;
  std::string contents;
};

/// Writes all files or none: no name changes before every byte is on the disk. Throws OutputError and leaves no temporary file; what a
/// killed writer left in the same folders is removed.
void write_files(const std::vector<OutputFile>& files);

/// Writes one file in the same way.
void write_file(const std::filesystem::path& path, std::string_view contents);

}  // namespace homolog
