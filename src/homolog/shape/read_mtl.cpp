// SPDX-License-Identifier: MIT
#include "homolog/shape/read_mtl.h"

#include <algorithm>

#include "homolog/shape/obj_lines.h"

namespace homolog {
namespace {

/// The file at the end of a line: all of it, as names may hold blanks, but after options (-s 1 1 1) the last word.
std::string picture_of(std::string_view line) {
  std::string name = rest_of(line);
  if (name.starts_with('-')) name.erase(0, name.find_last_of(" \t") + 1);
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

}  // namespace

std::vector<MtlMaterial> read_mtl(std::string_view content, const std::string& file) {
  Text text{file, content};
  std::vector<MtlMaterial> materials;
  std::string_view line;
  std::string joined;
  while (next_whole_line(text, line, joined)) {
    const std::string_view keyword = take_word(line);
    if (keyword == "newmtl") {
      materials.push_back({{rest_of(line), {0.8f, 0.8f, 0.8f, 1}, -1}, ""});
    } else if (materials.empty()) {
      continue;
    } else if (keyword == "Kd") {
      Rgba& colour = materials.back().material.colour;
      for (int k = 0; k < 3; ++k) colour[k] = static_cast<float>(std::clamp(take_number(text, line, "a colour"), 0.0, 1.0));
    } else if (keyword == "d") {
      materials.back().material.colour[3] = static_cast<float>(std::clamp(take_number(text, line, "the opacity"), 0.0, 1.0));
    } else if (keyword == "map_Kd") {
      materials.back().picture = picture_of(line);
    }
  }
  return materials;
}

}  // namespace homolog
