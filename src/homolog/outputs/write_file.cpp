// SPDX-License-Identifier: MIT
// Temporary names, then renaming: a reader never sees half a file.
#include "homolog/outputs/write_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <fstream>
#include <system_error>

#include "homolog/base/errors.h"

namespace homolog {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw OutputError(fmt::format("cannot write '{}': {}", path.string(), reason));
}

std::string reason_of(int error) { return error ? std::generic_category().message(error) : "unknown reason"; }

/// Files under temporary names; those not renamed when it dies are removed.
class Staged {
 public:
  Staged() = default;
  Staged(const Staged&) = delete;
  Staged& operator=(const Staged&) = delete;
  ~Staged() {
    std::error_code ignored;
    for (const auto& [temporary, path] : files_) fs::remove(temporary, ignored);
  }

  void add(const fs::path& path, std::string_view contents) {
    // Process and clock keep apart two programs that write into one folder.
    const auto stamp = std::chrono::steady_clock::now().time_since_epoch().count();
    const fs::path temporary = path.parent_path() / fmt::format(".{}.{}.{:x}.partial", path.filename().string(), getpid(), stamp);
    if (std::error_code ignored; fs::is_directory(path, ignored)) fail(path, "a folder has this name");
    errno = 0;
    std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
    if (!stream) fail(path, reason_of(errno));
    files_.emplace_back(temporary, path);
    stream.write(contents.data(), static_cast<std::streamsize>(contents.size()));
    stream.close();
    if (!stream) fail(path, reason_of(errno));
  }

  void rename_all() {
    for (const auto& [temporary, path] : files_) {
      std::error_code error;
      fs::rename(temporary, path, error);
      if (error) fail(path, error.message());
    }
    files_.clear();
  }

 private:
  std::vector<std::pair<fs::path, fs::path>> files_;
};

}  // namespace

void write_files(const std::vector<OutputFile>& files) {
  Staged staged;
  for (const OutputFile& file : files) staged.add(file.path, file.contents);
  staged.rename_all();
}

void write_file(const fs::path& path, std::string_view contents) {
  Staged staged;
  staged.add(path, contents);
  staged.rename_all();
}

}  // namespace homolog
