// SPDX-License-Identifier: MIT
#include "homolog/base/read_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>

#include "homolog/base/errors.h"

namespace homolog {

void check_file(const std::filesystem::path& path, std::uint64_t most) {
  if (path.empty()) throw FileError("the name of a file is empty; name the file to read");
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::none)
    throw FileError(fmt::format("{}: the file cannot be opened ({}); check the path", path.string(), error.message()));
  if (!std::filesystem::exists(status)) throw FileError(fmt::format("{}: there is no such file; check the path", path.string()));
  if (std::filesystem::is_directory(status)) throw FileError(fmt::format("{}: this is a directory; name a file in it", path.string()));
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw FileError(fmt::format("{}: this is not a regular file; save its contents to one", path.string()));
  if (size == 0) throw FileError(fmt::format("{}: the file is empty; export it again", path.string()));
  if (size > most) {
    throw FileError(fmt::format("{}: the file has {} bytes, more than the {} that are read; make it smaller", path.string(), size, most));
  }
}

std::string read_file(const std::filesystem::path& path, std::uint64_t most) {
  check_file(path, most);
  std::ifstream stream(path, std::ios::binary);
  std::string content(std::filesystem::file_size(path), '\0');
  if (!stream.read(content.data(), static_cast<std::streamsize>(content.size()))) {
    throw FileError(fmt::format("{}: the file cannot be read; check its permissions", path.string()));
  }
  return content;
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension;
}

}  // namespace homolog
