// SPDX-License-Identifier: MIT
// The files in a zip archive that is in memory, by minizip.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace homolog {

class ZipArchive {
 public:
  /// `content` must outlive this; `file` is the name for messages. Throws FileError for what is no archive.
  ZipArchive(std::string_view content, std::string file);
  ~ZipArchive();

  /// A file of the archive, whatever its letters' case; none if it is not there. Throws FileError when it is damaged, or longer than
  /// `most`.
  std::optional<std::string> read(const std::string& name, std::uint64_t most) const;

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
  void* archive_;
  std::string file_;
};

}  // namespace homolog
