// SPDX-License-Identifier: MIT
// The folder of --out: tried before the long computation, filled whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace homolog::cli {

class ResultFolder {
 public:
  /// Tries to make the folder and to write there, and leaves nothing of it, so that neither a failure nor Ctrl-C leaves an empty folder;
  /// an empty path means that no files are wanted. Throws OutputError.
  explicit ResultFolder(std::filesystem::path path);

  bool wanted() const { return !path_.empty(); }
  std::filesystem::path operator/(const char* name) const { return path_ / name; }

  /// Makes the folder and writes (name, contents) pairs, all or none. Throws OutputError.
  void write(const std::vector<std::pair<std::string, std::string>>& files) const;

 private:
  std::filesystem::path path_;
};

}  // namespace homolog::cli
