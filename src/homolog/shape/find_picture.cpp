// SPDX-License-Identifier: MIT
#include "homolog/shape/find_picture.h"

#include <algorithm>
#include <filesystem>

#include "homolog/shape/text.h"

namespace homolog {

int find_picture(const std::string& named, const FindOther& find_other, std::vector<Image>& images, std::vector<std::string>& missing) {
  const std::string name = std::filesystem::path(named).filename().string();
  const auto found = std::find_if(images.begin(), images.end(), [&](const Image& image) { return image.name == name; });
  if (found != images.end()) return static_cast<int>(found - images.begin());
  const std::optional<std::string> bytes = find_other(named);
  if (!bytes) {
    tell_missing(named, missing);
    return -1;
  }
  images.push_back({name, *bytes});
  return static_cast<int>(images.size()) - 1;
}

void tell_missing(const std::string& name, std::vector<std::string>& missing) {
  const std::string told = shown(name, longest_name);
  if (std::find(missing.begin(), missing.end(), told) == missing.end()) missing.push_back(told);
}

}  // namespace homolog
