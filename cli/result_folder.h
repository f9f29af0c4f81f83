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
  /// Makes the folder if it is missing and tries to write there; an empty path means that no files are wanted. Throws OutputError.
  explicit ResultFolder(std::filesystem::path path);
  /// Takes away the folders it made if nothing was written into them.
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  bool wanted() const { return !path_.empty(); }
  std::filesystem::path operator/(const char* name) const { return path_ / name; }

  /// Writes (name, contents) pairs, all or none. Throws OutputError.
  void write(const std::vector<std::pair<std::string, std::string>>& files) const;

 private:
  void remove_empty() const;

  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  ///< outermost first
};

}  // namespace homolog::cli
