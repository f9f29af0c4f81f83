// SPDX-License-Identifier: MIT
#include "homolog/outputs/write_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "homolog/base/errors.h"
#include "homolog/outputs/write_file.h"

namespace homolog {
namespace fs = std::filesystem;

namespace {

/// Why a folder cannot be had, and what to do.
std::string refusal(const std::error_code& error) {
  if (error == std::errc::not_a_directory || error == std::errc::file_exists)
    return "a file, or a link that leads nowhere, is in its way; choose another folder";
  return error.message() + (error == std::errc::permission_denied ? "; choose one that you may write into" : "; choose another folder");
}

/// While it lives, no other process of ours writes into the folder: of two with the same --out one comes after the other, whole. A file
/// system that knows no locks leaves it to chance.
class Locked {
 public:
  explicit Locked(const fs::path& folder) : folder_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) { flock(folder_, LOCK_EX); }
  ~Locked() { close(folder_); }
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;

 private:
  int folder_;
};

/// Makes the folder and those above it; removes the ones it made, innermost first, unless it is told to keep them.
class MadeFolders {
 public:
  explicit MadeFolders(const fs::path& path) {
    std::error_code error;
    for (fs::path folder = path; !folder.empty() && !fs::exists(folder, error); folder = folder.parent_path()) made_.push_back(folder);
    fs::create_directories(path, error);
    if (!error) return;
    remove();
    throw OutputError(fmt::format("cannot make the folder '{}': {}", path.string(), refusal(error)));
  }
  ~MadeFolders() { remove(); }
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;

  void keep() { made_.clear(); }

 private:
  void remove() const {
    std::error_code ignored;  // a folder with something in it stays
    for (const fs::path& folder : made_) fs::remove(folder, ignored);
  }

  std::vector<fs::path> made_;  ///< innermost first
};

}  // namespace

void require_writable_folder(const fs::path& path) {
  std::error_code error;
  const fs::path asked = fs::absolute(path, error);
  fs::path there = asked;
  while (!error && !fs::exists(there, error) && !error && !fs::is_symlink(there)) there = there.parent_path();
  const bool exists = there == asked;
  if (!error && !fs::is_directory(there)) error = std::make_error_code(std::errc::not_a_directory);
  if (!error && access(there.c_str(), W_OK | X_OK) != 0) error = std::error_code(errno, std::generic_category());
  if (error && !exists) throw OutputError(fmt::format("cannot make the folder '{}': {}", path.string(), refusal(error)));
  if (error) throw OutputError(fmt::format("cannot write into the folder '{}': {}", path.string(), refusal(error)));
}

void write_folder(const fs::path& folder, const NamedFiles& files, const std::vector<fs::path>& read) {
  std::vector<StreamedFile> outputs;
  for (const auto& [name, writing] : files) outputs.push_back({folder / name, writing});
  MadeFolders made(folder);
  const Locked locked(folder);
  write_files(outputs, read);
  made.keep();
}

}  // namespace homolog
