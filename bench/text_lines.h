// SPDX-License-Identifier: MIT
// A text file line by line, with the place for messages.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "homolog/base/errors.h"

namespace homolog::bench {

struct TextLines {
  std::filesystem::path file;
  std::ifstream in{file};  ///< false in a condition if there is no such file
  std::string line = {};
  int number = 0;  ///< of the line, from 1
};

/// Reads the next line, without the CR that Windows leaves; false at the end.
bool next_line(TextLines& lines);

/// The same, passing over empty lines and comments (#).
bool next_entry(TextLines& lines);

/// "FILE, line N: what"
FileError fault_at(const std::filesystem::path& file, int line, const std::string& what);
FileError fault_at(const TextLines& lines, const std::string& what);

}  // namespace homolog::bench
