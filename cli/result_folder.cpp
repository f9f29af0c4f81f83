// SPDX-License-Identifier: MIT
#include "result_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include "homolog/base/errors.h"
#include "homolog/outputs/write_file.h"

namespace homolog::cli {
namespace fs = std::filesystem;

namespace {

/// While it lives, Ctrl-C and its like do not stop the program: the moment of writing, seconds for millions of triangles, ends with all
/// files or none.
class Uninterrupted {
 public:
  Uninterrupted() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) before_[i] = std::signal(kSignals[i], SIG_IGN);
  }
  ~Uninterrupted() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) std::signal(kSignals[i], before_[i]);
  }
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;

 private:
  static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
  std::array<void (*)(int), kSignals.size()> before_{};
};

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

/// Throws unless the folder can be written into, or be made where it would lie. Nothing is tried out: what one process made for a trial and
/// took away again could be what another one is about to use.
void require_writable(const fs::path& path) {
  std::error_code error;
  fs::path there = fs::absolute(path);
  while (!fs::exists(there, error) && !error) there = there.parent_path();
  const bool exists = there == fs::absolute(path);
  if (!error && !fs::is_directory(there)) error = std::make_error_code(std::errc::not_a_directory);
  if (!error && access(there.c_str(), W_OK | X_OK) != 0) error = std::error_code(errno, std::generic_category());
  if (error && !exists) throw OutputError(fmt::format("cannot make the folder '{}': {}", path.string(), error.message()));
  if (error) throw OutputError(fmt::format("cannot write into the folder '{}': {}", path.string(), error.message()));
}

/// Makes the folder and those above it; removes the ones it made, innermost first, unless it is told to keep them.
class MadeFolders {
 public:
  explicit MadeFolders(const fs::path& path) {
    std::error_code error;
    for (fs::path folder = path; !folder.empty() && !fs::exists(folder, error); folder = folder.parent_path()) made_.push_back(folder);
    fs::create_directories(path, error);
    if (!error) return;
    remove();
    throw OutputError(fmt::format("cannot make the folder '{}': {}", path.string(), error.message()));
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

ResultFolder::ResultFolder(fs::path path) : path_(std::move(path)) {
  if (!path_.empty()) require_writable(path_);
}

void ResultFolder::write(const std::vector<std::pair<std::string, Writing>>& files) const {
  std::vector<StreamedFile> outputs;
  for (const auto& [name, writing] : files) outputs.push_back({path_ / name, writing});
  const Uninterrupted uninterrupted;
  MadeFolders made(path_);
  const Locked locked(path_);
  write_files(outputs);
  made.keep();
}

}  // namespace homolog::cli
