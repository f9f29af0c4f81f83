// SPDX-License-Identifier: MIT
#include "homolog/shape/find_picture.h"

#include <filesystem>

#include "homolog/shape/outside_folder.h"
#include "homolog/shape/text.h"

namespace homolog {

std::optional<std::string> picture_bytes(const std::string& name, const std::function<std::optional<std::string>()>& find,
                                         PictureLosses losses) {
  try {
    std::optional<std::string> bytes = find();
    if (!bytes) tell_missing(name, losses.missing);
    return bytes;
  } catch (const OutsideFolder&) {
    losses.left_out.push_back(
        fmt::format("the picture '{}', which lies outside the folder of the file and is not opened; put it beside "
                    "the file (Blender's OBJ export: Path Mode Copy)",
                    shown(name, longest_name)));
    return {};
  }
}

int find_picture(const std::string& named, const FindOther& find_other, std::vector<Image>& images, PictureNumbers& numbers,
                 PictureLosses losses) {
  const std::filesystem::path path = std::filesystem::path(named).lexically_normal();
  const auto [known, is_new] = numbers.try_emplace(path.string(), -1);
  if (!is_new) return known->second;
  const std::optional<std::string> bytes = picture_bytes(
      named, [&] { return find_other(named); }, losses);
  if (!bytes) return -1;
  known->second = static_cast<int>(images.size());
  images.push_back({free_name(images, path.filename().string()), *bytes});
  return known->second;
}

void tell_missing(const std::string& name, std::vector<std::string>& missing) {
  const std::string told = shown(name, longest_name);
  if (std::find(missing.begin(), missing.end(), told) == missing.end()) missing.push_back(told);
}

}  // namespace homolog
