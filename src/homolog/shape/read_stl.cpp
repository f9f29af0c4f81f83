// SPDX-License-Identifier: MIT
#include "homolog/shape/read_stl.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "homolog/base/errors.h"
#include "homolog/shape/text.h"
#include "homolog/shape/weld.h"

namespace homolog {
namespace {

constexpr std::size_t header_bytes = 84, triangle_bytes = 50;  // a comment of 80 and the count; normal, three vertices, 2 spare

std::uint32_t little_endian(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

std::size_t announced_triangles(std::string_view content) {
  return content.size() < header_bytes ? 0 : little_endian(content.data() + header_bytes - 4);
}

/// The word "solid" alone is no proof, many binary files start with it.
bool is_text(std::string_view content) {
  if (content.size() == header_bytes + triangle_bytes * announced_triangles(content)) return false;
  content.remove_prefix(std::min(content.find_first_not_of(" \t\r\n"), content.size()));
  return lower(content.substr(0, 5)) == "solid" && content.substr(0, 1000).find('\0') == std::string_view::npos;
}

Mesh read_binary(std::string_view content, const std::string& file) {
  const std::size_t count = announced_triangles(content);
  if (content.size() >= header_bytes && content.substr(0, 1000).find('\0') == std::string_view::npos) {
    throw FileError(fmt::format("{}: this is neither STL as text, which begins with 'solid', nor as numbers; export it again", file));
  }
  if (content.size() < header_bytes || (content.size() - header_bytes) / triangle_bytes < count) {
    throw FileError(
        fmt::format("{}: {} triangles are announced, but the file is too short for them; it is truncated or damaged", file, count));
  }
  if (content.size() - header_bytes - triangle_bytes * count >= triangle_bytes) {  // a few bytes at the end are a habit
    throw FileError(fmt::format("{}: {} triangles are announced, but the file goes on after them; export it again", file, count));
  }
  Welder welder;
  for (std::size_t i = 0; i < count; ++i) {
    const char* bytes = content.data() + header_bytes + i * triangle_bytes + 12;
    Triangle triangle;
    for (std::uint32_t& corner : triangle) {
      Vec3 vertex;
      for (int axis = 0; axis < 3; ++axis, bytes += 4) vertex[axis] = std::bit_cast<float>(little_endian(bytes));
      if (!vertex.allFinite()) {
        throw FileError(fmt::format("{}, triangle {}: a coordinate is not a finite number; the file is damaged", file, i));
      }
      corner = welder.vertex_at(vertex);
    }
    welder.add_triangle(triangle);
  }
  return std::move(welder.mesh);
}

/// What has been read of a text: whole triangles, and the corners of the facet that is open.
struct Facets {
  Welder welder;
  Triangle corners = {};
  std::size_t count = 0;  ///< of corners, three if the facet is right
  bool ended = false;     ///< the last word was endsolid
};

void end_facet(Text& text, Facets& facets) {
  if (facets.count != 3) fail(text, "a facet has not three vertices; the file is damaged");
  facets.welder.add_triangle(facets.corners);
  facets.count = 0;
}

/// Takes words off a line until this one is taken, or all.
void skip_to(std::string_view& line, std::string_view last) {
  std::string_view word;
  do {
    word = take_word(line);
  } while (!word.empty() && lower(word) != last);
}

// What stands in a line, which may be a whole facet or solid. Whatever follows "solid" and "facet", a name or a normal, says nothing of the
// shape.
void read_line(Text& text, std::string_view line, Facets& facets) {
  for (std::string word = lower(take_word(line)); !word.empty(); word = lower(take_word(line))) {
    facets.ended = word == "endsolid";
    if (word == "vertex") {
      const std::uint32_t vertex = facets.welder.vertex_at(take_position(text, line));
      if (facets.count < 3) facets.corners[facets.count] = vertex;
      ++facets.count;
    } else if (word == "endfacet") {
      end_facet(text, facets);
    } else if (word == "facet" || word == "solid" || word == "endsolid") {
      if (facets.count != 0) fail(text, "a facet has not three vertices; the file is damaged");
      if (word == "endsolid") skip_to(line, "solid");
      if (word != "facet") skip_to(line, "facet");
      skip_to(line, "outer");
    } else if (word != "outer" && word != "loop" && word != "endloop") {
      fail(text, "the line holds a word that STL does not know; the file is damaged");
    }
  }
}

Mesh read_text(std::string_view content, const std::string& file) {
  Text text{file, content};
  Facets facets;
  std::string_view line;
  while (next_line(text, line)) read_line(text, line, facets);
  if (!facets.ended) fail(text, "the file ends before the word endsolid; it is truncated");
  return std::move(facets.welder.mesh);
}

}  // namespace

bool is_stl(std::string_view content) {
  const std::size_t count = announced_triangles(content);
  if (count > 0 && content.size() == header_bytes + triangle_bytes * count) return true;
  return is_text(content) && content.substr(0, 1000).find("facet") != std::string_view::npos;
}

Mesh read_stl(std::string_view content, const std::string& file) {
  return is_text(content) ? read_text(content, file) : read_binary(content, file);
}

}  // namespace homolog
