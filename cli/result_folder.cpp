// SPDX-License-Identifier: MIT
#include "result_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>
#include <system_error>

#include "homolog/base/errors.h"
#include "homolog/outputs/write_file.h"

namespace homolog::cli {
namespace fs = std::filesystem;

ResultFolder::ResultFolder(fs::path path) : path_(std::move(path)) {
  if (path_.empty()) return;
  std::error_code error;
  for (fs::path folder = path_; !folder.empty() && !fs::exists(folder, error); folder = folder.parent_path()) made_.push_back(folder);
  std::ranges::reverse(made_);
  fs::create_directories(path_, error);
  if (error) {
    remove_empty();
    throw OutputError(fmt::format("cannot make the folder '{}': {}", path_.string(), error.message()));
  }
  const fs::path probe = path_ / ".homolog-writable";
  try {
    write_file(probe, "");
  } catch (const OutputError&) {
    remove_empty();
    throw OutputError(fmt::format("cannot write into the folder '{}'", path_.string()));
  }
  fs::remove(probe, error);
}

ResultFolder::~ResultFolder() { remove_empty(); }

void ResultFolder::remove_empty() const {
  std::error_code ignored;  // a folder with something in it stays
  for (const fs::path& folder : made_ | std::views::reverse) fs::remove(folder, ignored);
}

void ResultFolder::write(const std::vector<std::pair<std::string, std::string>>& files) const {
  std::vector<OutputFile> outputs;
  for (const auto& [name, contents] : files) outputs.push_back({path_ / name, contents});
  write_files(outputs);
}

}  // namespace homolog::cli
