// SPDX-License-Identifier: MIT
// Every file appears whole or not at all: written under temporary names in the same folder, then renamed, one after the other.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "homolog/outputs/sink.h"

namespace homolog {

struct OutputFile {
  std::filesystem::path path;
  std::string contents;
};

/// A file that is made while it is written.
struct StreamedFile {
  std::filesystem::path path;
  Writing writing;
};

/// Writes all files or none: no name changes before every byte is on the disk. Throws OutputError and leaves no temporary file, also if
/// one of the files is one of `read`, those that the results were made from, which would be lost; what a killed writer left in the same
/// folders is removed.
void write_files(const std::vector<StreamedFile>& files, const std::vector<std::filesystem::path>& read = {});
void write_files(const std::vector<OutputFile>& files, const std::vector<std::filesystem::path>& read = {});

/// Writes one file in the same way.
void write_file(const std::filesystem::path& path, std::string_view contents);

}  // namespace homolog
