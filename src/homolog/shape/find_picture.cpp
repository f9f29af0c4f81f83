// SPDX-License-Identifier: MIT
#include "homolog/shape/find_picture.h"

#include <filesystem>

#include "homolog/shape/text.h"

namespace homolog {

int find_picture(const std::string& named, const FindOther& find_other, std::vector<Image>& images, PictureNumbers& numbers,
                 std::vector<std::string>& missing) {
  const std::filesystem::path path = std::filesystem::path(named).lexically_normal();
  const auto [known, is_new] = numbers.try_emplace(path.string(), -1);
  if (!is_new) return known->second;
  const std::optional<std::string> bytes = find_other(named);
  if (!bytes) {
    tell_missing(named, missing);
    return -1;
  }
  known->second = static_cast<int>(images.size());
  images.push_back({free_name(images, path.filename().string()), *bytes});
  return known->second;
}

void tell_missing(const std::string& name, std::vector<std::string>& missing) {
  const std::string told = shown(name, longest_name);
  if (std::find(missing.begin(), missing.end(), told) == missing.end()) missing.push_back(told);
}

}  // namespace homolog
