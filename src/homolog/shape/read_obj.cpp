// SPDX-License-Identifier: MIT
#include "homolog/shape/read_obj.h"

#include <fmt/format.h>

#include "homolog/shape/polygon.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

/// A face whose corners are still the file's numbers, from 1; they may name vertices that come later.
struct Face {
  std::size_t line;
  std::vector<std::uint32_t> corners;
};

/// The vertex number of a corner such as "7", "7/1/2" or "-1" (the last vertex so far), counted from 0.
std::uint32_t read_corner(Text& text, std::string_view word, std::size_t vertices_so_far) {
  std::string_view number = word.substr(0, word.find('/'));
  const long long written = take_integer(text, number, "the vertex number of a face");
  const long long index = written < 0 ? static_cast<long long>(vertices_so_far) + written : written - 1;
  if (written == 0 || index < 0 || index > 0xfffffffeLL) {
    fail(text, fmt::format("vertex {} does not exist (vertices count from 1); the file is damaged", written));
  }
  return static_cast<std::uint32_t>(index);
}

/// Lines that end in a backslash go on in the next one.
bool next_whole_line(Text& text, std::string_view& line, std::string& joined) {
  if (!next_data_line(text, line)) return false;
  if (line.back() != '\\') return true;
  joined.clear();
  bool more = true;
  while (more && !line.empty() && line.back() == '\\') {
    joined.append(line.substr(0, line.size() - 1)).append(" ");
    more = next_line(text, line);
  }
  if (more) joined.append(line);
  line = joined;
  return true;
}

}  // namespace

Mesh read_obj(std::string_view content, const std::string& file) {
  Text text{file, content};
  Mesh mesh;
  std::vector<Face> faces;
  std::string_view line;
  std::string joined;
  while (next_whole_line(text, line, joined)) {
    const std::string_view keyword = take_word(line);
    if (keyword == "v") mesh.vertices.push_back(take_position(text, line));
    if (keyword != "f" && keyword != "fo") continue;
    Face face{text.line, {}};
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
      face.corners.push_back(read_corner(text, word, mesh.vertices.size()));
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
  return mesh;
}

}  // namespace homolog
