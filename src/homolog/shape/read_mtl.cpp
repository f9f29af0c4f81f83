// SPDX-License-Identifier: MIT
#include "homolog/shape/read_mtl.h"

#include <algorithm>

#include "homolog/shape/obj_lines.h"

namespace homolog {
namespace {

/// How many words an option of a map takes at most, those of the second kind only as long as they are numbers.
int words_after(std::string_view option) { return option == "-mm" ? 2 : option == "-o" || option == "-s" || option == "-t" ? 3 : 1; }

bool is_number(std::string_view word) { return !word.empty() && word.find_first_not_of("+-.0123456789eE") == word.npos; }

/// The file at the end of a line, after options (-s 1 1 1): all of the rest, as names may hold blanks.
std::string picture_of(std::string_view line) {
  std::string_view rest = line;
  for (std::string_view word = take_word(rest); word.starts_with('-'); word = take_word(rest)) {
    const int most = words_after(word);
    for (int taken = 0; taken < most; ++taken) {
      std::string_view next = rest;
      if (!is_number(take_word(next)) && most > 1) break;
      rest = next;
    }
    line = rest;
  }
  std::string name = rest_of(line);
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

bool is_other_map(std::string_view keyword) {
  return keyword.starts_with("map_") || keyword == "bump" || keyword == "norm" || keyword == "disp" || keyword == "decal" ||
         keyword == "refl";
}

}  // namespace

MtlFile read_mtl(std::string_view content, const std::string& file) {
  Text text{file, content};
  MtlFile mtl;
  std::vector<MtlMaterial>& materials = mtl.materials;
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
    } else if (is_other_map(keyword) && std::find(mtl.other_maps.begin(), mtl.other_maps.end(), keyword) == mtl.other_maps.end()) {
      mtl.other_maps.emplace_back(keyword);
    }
  }
  return mtl;
}

}  // namespace homolog
