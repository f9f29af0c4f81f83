// SPDX-License-Identifier: MIT
// A file in the making: it lies beside where it belongs, under a name of its own, and is locked as long as its writer lives.
#pragma once

#include <filesystem>
#include <string_view>

namespace homolog {

class PartialFile {
 public:
  /// An empty one, which leaves what lies at `path` as it is. A device or a pipe there is written into at once, since a file in its place
  /// would take it from everybody. Throws OutputError.
  explicit PartialFile(const std::filesystem::path& path);
  /// Removes it, unless it has got its name.
  ~PartialFile();
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  /// Throws OutputError.
  void append(std::string_view piece);
  /// Throws OutputError unless all of it arrived; some file systems tell only when a file is closed.
  void complete();
  /// Gives it the name `path`. Throws OutputError.
  void rename();

 private:
  std::filesystem::path path_, partial_;
  int file_ = -1;
};

/// Removes the partial files of writers that were killed. Those of the living stay: the system gives up a lock when its process ends,
/// however it does. Where files cannot be locked, all stay.
void remove_leftovers(const std::filesystem::path& folder);

}  // namespace homolog
