// SPDX-License-Identifier: MIT
#include "homolog/outputs/pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "homolog/outputs/specimen.h"

namespace homolog {

std::string picture_name(const std::filesystem::path& out, const Image& image) {
  return fmt::format("{}.{}", out.stem().string(), one_line(image.name));
}

std::vector<OutputFile> picture_files(const Texturing& texturing, const std::filesystem::path& out) {
  std::vector<OutputFile> files;
  for (std::size_t i = 0; i < texturing.images.size(); ++i) {
    const bool used = std::any_of(texturing.materials.begin(), texturing.materials.end(),
                                  [&](const Material& material) { return material.image == static_cast<int>(i); });
    const Image& image = texturing.images[i];
    if (used && !image.bytes.empty()) files.push_back({out.parent_path() / picture_name(out, image), image.bytes});
  }
  return files;
}

}  // namespace homolog
