// SPDX-License-Identifier: MIT
#include "homolog/outputs/partial_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <utility>

#include "homolog/base/errors.h"

namespace homolog {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = ".homolog.", suffix = ".partial";

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw OutputError(fmt::format("cannot write '{}': {}", path.string(), reason));
}

/// Why the system refuses, and what to do.
std::string reason_of(int error) {
  if (error == ENOENT) return "its folder is not there; make it first, or choose another name";
  if (error == ENOTDIR) return "a file is where its folder should be; choose another name";
  if (error == ENAMETOOLONG) return "the name is too long; choose a shorter one";
  const std::string message = std::generic_category().message(error);
  if (error == EACCES || error == EPERM || error == EROFS) return message + "; choose a folder that you may write into";
  return message + (error == ENOSPC || error == EDQUOT ? "; make room, or choose another place" : "; choose another place");
}

/// Where a link leads, so that it stays a link; a link that leads nowhere is replaced.
fs::path followed(const fs::path& path) {
  std::error_code not_there;
  const fs::path target = fs::is_symlink(path, not_there) ? fs::canonical(path, not_there) : fs::path();
  return target.empty() ? path : target;
}

/// Process and clock keep apart what is written into one folder at once.
fs::path partial_name(const fs::path& path) {
  const auto stamp = std::chrono::steady_clock::now().time_since_epoch().count();
  return path.parent_path() / fmt::format("{}{}.{:x}{}", prefix, getpid(), stamp, suffix);
}

/// Between making a file and locking it, it looks like a leftover, and somebody may remove it.
bool was_removed(int file) {
  struct stat status {};
  return fstat(file, &status) == 0 && status.st_nlink == 0;
}

}  // namespace

PartialFile::PartialFile(const fs::path& path) : path_(followed(path)) {
  std::error_code ignored;
  const fs::file_status there = fs::status(path_, ignored);
  if (fs::is_directory(there)) fail(path_, "a folder has this name");
  if (fs::exists(there) && !fs::is_regular_file(there)) {
    if (!fs::is_character_file(there) && !fs::is_fifo(there)) fail(path_, "it is no file; choose another name");
    file_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) fail(path_, reason_of(errno));
    return;
  }
  while (file_ < 0) {
    partial_ = partial_name(path_);
    file_ = open(partial_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file_ < 0 && errno == EEXIST) continue;
    if (file_ < 0) fail(path_, reason_of(errno));
    flock(file_, LOCK_EX);
    if (was_removed(file_)) close(std::exchange(file_, -1));
  }
}

PartialFile::~PartialFile() {
  if (!partial_.empty()) unlink(partial_.c_str());
  close(file_);
}

void PartialFile::append(std::string_view piece) {
  while (!piece.empty()) {
    const ssize_t written = write(file_, piece.data(), piece.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path_, reason_of(errno));
    piece.remove_prefix(static_cast<std::size_t>(written));
  }
}

void PartialFile::complete() {
  const int again = dup(file_);
  if (again < 0 || close(again) != 0) fail(path_, reason_of(errno));
}

void PartialFile::rename() {
  if (partial_.empty()) return;
  std::error_code error;
  fs::rename(partial_, path_, error);
  if (error) fail(path_, reason_of(error.value()));
  partial_.clear();
}

void remove_leftovers(const fs::path& folder) {
  std::error_code ignored;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, ignored), end; entry != end; entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(prefix) || !name.ends_with(suffix)) continue;
    const int file = open(entry->path().c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (file < 0) continue;
    if (flock(file, LOCK_EX | LOCK_NB) == 0) unlink(entry->path().c_str());
    close(file);
  }
}

}  // namespace homolog
