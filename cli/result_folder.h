// SPDX-License-Identifier: MIT
// The folder of --out: asked for before the long computation, filled whole or not at all.
#pragma once

#include <filesystem>
#include <vector>

#include "homolog/outputs/write_folder.h"

namespace homolog::cli {

class ResultFolder {
 public:
  /// Asks whether the folder can be made and written into, and touches nothing, so that neither a failure nor Ctrl-C leaves an empty
  /// folder; an empty path means that no files are wanted. `read` are files that must not be overwritten. Throws OutputError.
  ResultFolder(std::filesystem::path path, std::vector<std::filesystem::path> read);

  bool wanted() const { return !path_.empty(); }
  std::filesystem::path operator/(const char* name) const { return path_ / name; }

  /// As write_folder() does; Ctrl-C does not stop it.
  void write(const NamedFiles& files) const;

 private:
  std::filesystem::path path_;
  std::vector<std::filesystem::path> read_;
};

}  // namespace homolog::cli
