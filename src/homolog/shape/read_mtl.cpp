// SPDX-License-Identifier: MIT
#include "homolog/shape/read_mtl.h"

#include <algorithm>
#include <cstdlib>

#include "homolog/shape/obj_lines.h"

namespace homolog {
namespace {

/// How many words an option of a map takes at most, those of the second kind only as long as they are numbers.
int words_after(std::string_view option) { return option == "-mm" ? 2 : option == "-o" || option == "-s" || option == "-t" ? 3 : 1; }

bool is_number(std::string_view word) { return !word.empty() && word.find_first_not_of("+-.0123456789eE") == word.npos; }

/// Whether an option with this word after it shows the picture otherwise than UVs alone say.
bool changes_picture(std::string_view option, const std::string& word) {
  if (option == "-clamp") return word == "on";
  if (option == "-mm") return true;
  if (option != "-s" && option != "-o" && option != "-t") return false;
  return std::strtod(word.c_str(), nullptr) != (option == "-s" ? 1 : 0);
}

void add_once(std::vector<std::string>& list, std::string_view word) {
  if (std::find(list.begin(), list.end(), word) == list.end()) list.emplace_back(word);
}

/// The file at the end of a line, after options (-s 1 1 1), of which those that say something are told: all of the rest, as names may hold
/// blanks.
std::string picture_of(std::string_view line, std::vector<std::string>& options) {
  std::string_view rest = line;
  for (std::string_view option = take_word(rest); option.starts_with('-'); option = take_word(rest)) {
    const int most = words_after(option);
    for (int taken = 0; taken < most; ++taken) {
      std::string_view next = rest;
      const std::string_view word = take_word(next);
      if (!is_number(word) && most > 1) break;
      if (changes_picture(option, std::string(word))) add_once(options, option);
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

/// What a line says of the last material.
void read_statement(MtlFile& mtl, Text& text, std::string_view keyword, std::string_view line) {
  MtlMaterial& last = mtl.materials.back();
  if (keyword == "Kd") {
    for (int k = 0; k < 3; ++k) last.material.colour[k] = static_cast<float>(std::clamp(take_number(text, line, "a colour"), 0.0, 1.0));
    last.has_colour = true;
  } else if (keyword == "d") {
    std::string_view rest = line;
    if (take_word(rest) == "-halo") line = rest;
    last.material.colour[3] = static_cast<float>(std::clamp(take_number(text, line, "the opacity"), 0.0, 1.0));
  } else if (keyword == "map_Kd") {
    last.picture = picture_of(line, mtl.map_options);
  } else if (is_other_map(keyword)) {
    add_once(mtl.other_maps, keyword);
  }
}

/// A picture is multiplied by Kd: by nothing where there is none, nor where it would be black, as some programs write it.
void whiten_below_picture(MtlMaterial& material) {
  Rgba& colour = material.material.colour;
  const bool is_black = colour[0] == 0 && colour[1] == 0 && colour[2] == 0;
  if (!material.picture.empty() && (!material.has_colour || is_black)) colour = {1, 1, 1, colour[3]};
}

}  // namespace

MtlFile read_mtl(std::string_view content, const std::string& file) {
  Text text{file, content};
  MtlFile mtl;
  std::string_view line;
  std::string joined;
  while (next_whole_line(text, line, joined)) {
    const std::string_view keyword = take_word(line);
    if (keyword == "newmtl") {
      mtl.materials.push_back({{rest_of(line), {0.8f, 0.8f, 0.8f, 1}, -1}, ""});
    } else if (!mtl.materials.empty()) {
      read_statement(mtl, text, keyword, line);
    }
  }
  for (MtlMaterial& material : mtl.materials) whiten_below_picture(material);
  return mtl;
}

}  // namespace homolog
