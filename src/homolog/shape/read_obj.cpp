// SPDX-License-Identifier: MIT
#include "homolog/shape/read_obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "homolog/shape/obj_lines.h"
#include "homolog/shape/polygon.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

/// A face whose corners are still the file's numbers, from 1; they may name vertices that come later.
struct Face {
  std::size_t line;
  std::vector<std::uint32_t> corners;
};

}  // namespace

bool is_obj(std::string_view content) {
  static constexpr std::string_view words[] = {"v", "vn", "vt", "o", "g", "mtllib", "usemtl", "s"};
  Text text{"", content};
  std::string_view line;
  return next_data_line(text, line) && std::count(std::begin(words), std::end(words), take_word(line)) > 0;
}

Mesh read_obj(std::string_view content, const std::string& file, const Tell& tell) {
  Text text{file, content};
  Mesh mesh;
  std::vector<Face> faces;
  std::size_t free_forms = 0;
  std::string_view line;
  std::string joined;
  while (next_whole_line(text, line, joined)) {
    const std::string_view keyword = take_word(line);
    if (keyword == "v") mesh.vertices.push_back(take_position(text, line));
    free_forms += keyword == "surf";
    if (keyword != "f" && keyword != "fo") continue;
    Face face{text.line, {}};
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
      face.corners.push_back(obj_number(text, word.substr(0, word.find('/')), mesh.vertices.size(), "vertex"));
    }
    faces.push_back(std::move(face));
  }
  for (Face& face : faces) {
    text.line = face.line;
    for (const std::uint32_t corner : face.corners) {
      if (corner >= mesh.vertices.size()) {
        fail(text, fmt::format("vertex {} does not exist (the file has {}); the file is truncated or damaged", corner + 1ll,
                               mesh.vertices.size()));
      }
    }
    append_polygon(mesh, std::move(face.corners));
  }
  if (free_forms > 0 && tell)
    tell(fmt::format("{} free-form surface{} left out; make polygons of what is missing and export it again", free_forms,
                     free_forms == 1 ? " (surf) is" : "s (surf) are"));
  return mesh;
}

}  // namespace homolog
