// SPDX-License-Identifier: MIT
#include "homolog/shape/read_off.h"

#include <fmt/format.h>

#include "homolog/shape/polygon.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

struct Counts {
  long long vertices, faces;
};

Counts read_header(Text& text) {
  std::string_view line;
  if (!next_data_line(text, line)) fail(text, "the file is empty");
  std::string_view after = line;
  const std::string_view word = take_word(after);
  if (word.ends_with("OFF")) {
    if (word != "OFF" && word != "COFF" && word != "NOFF" && word != "CNOFF" && word != "STOFF" && word != "STCNOFF") {
      fail(text, "this kind of OFF file is not supported; save it as plain OFF or PLY");
    }
    line = after;
    if (line.find("BINARY") != std::string_view::npos) fail(text, "binary OFF is not supported; save it as plain OFF or PLY");
    std::string_view rest = line;
    if (take_word(rest).empty() && !next_data_line(text, line)) fail(text, "the file ends before the numbers of vertices and faces");
  }
  Counts counts{};
  counts.vertices = take_integer(text, line, "the number of vertices (after the word OFF)");
  if (rest_of(line).empty() && !text.rest.empty()) {
    fail(text, "the numbers of vertices and faces must stand in one line, as each vertex and each face must; save it so, or as PLY");
  }
  counts.faces = take_integer(text, line, "the number of faces");
  const auto left = static_cast<long long>(text.rest.size());
  if (counts.vertices < 0 || counts.faces < 0 || counts.vertices > left / 5 || counts.faces > left / 3) {  // a line "0 0 0" or "1 0"
    fail(text, fmt::format("{} vertices and {} faces are announced, but the rest of the file is too short for them; it is truncated, or "
                           "not every vertex and face has a line of its own",
                           counts.vertices, counts.faces));
  }
  return counts;
}

void read_face(Text& text, std::string_view line, Mesh& mesh) {
  const long long size = take_integer(text, line, "the number of corners of a face");
  if (size < 0 || size > static_cast<long long>(line.size() / 2)) {
    fail(text, fmt::format("a face of {} corners does not fit its line; the file is truncated or damaged", size));
  }
  std::vector<std::uint32_t> corners(static_cast<std::size_t>(size));
  for (std::uint32_t& corner : corners) {
    const long long index = take_integer(text, line, "a vertex number");
    if (index < 0 || index >= static_cast<long long>(mesh.vertices.size())) {
      fail(text,
           fmt::format("vertex {} does not exist (the file has {}, counted from 0); the file is damaged", index, mesh.vertices.size()));
    }
    corner = static_cast<std::uint32_t>(index);
  }
  append_polygon(mesh, std::move(corners));
}

}  // namespace

bool is_off(std::string_view content) {
  Text text{"", content};
  std::string_view line;
  return next_data_line(text, line) && take_word(line).ends_with("OFF");
}

Mesh read_off(std::string_view content, const std::string& file) {
  Text text{file, content};
  const Counts counts = read_header(text);
  Mesh mesh;
  mesh.vertices.reserve(static_cast<std::size_t>(counts.vertices));
  std::string_view line;
  for (long long i = 0; i < counts.vertices; ++i) {
    if (!next_data_line(text, line))
      fail(text, fmt::format("the file ends after {} of {} vertices; it is truncated, or not every vertex has a line of its own", i,
                             counts.vertices));
    mesh.vertices.push_back(take_position(text, line));
  }
  for (long long i = 0; i < counts.faces; ++i) {
    if (!next_data_line(text, line))
      fail(text, fmt::format("the file ends after {} of {} faces; it is truncated, or not every vertex and face has a line of its own", i,
                             counts.faces));
    read_face(text, line, mesh);
  }
  if (next_data_line(text, line)) {
    fail(text, fmt::format("{} faces are announced, but the file goes on after them; export it again", counts.faces));
  }
  return mesh;
}

}  // namespace homolog
