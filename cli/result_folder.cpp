// SPDX-License-Identifier: MIT
#include "result_folder.h"

#include <array>
#include <csignal>

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

}  // namespace

ResultFolder::ResultFolder(fs::path path, std::vector<fs::path> read) : path_(std::move(path)), read_(std::move(read)) {
  if (!path_.empty()) require_writable_folder(path_);
}

void ResultFolder::write(const NamedFiles& files) const {
  const Uninterrupted uninterrupted;
  write_folder(path_, files, read_);
}

}  // namespace homolog::cli
