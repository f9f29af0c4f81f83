// SPDX-License-Identifier: MIT
#include "homolog/outputs/ply.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <iterator>
#include <string_view>

namespace homolog {
namespace {

constexpr std::size_t piece = 1 << 16;  // bytes that are passed on together

std::string header(const Mesh& mesh, bool coloured, const std::vector<VertexColumn>& columns, bool laid, const std::string& comment) {
  std::string text = fmt::format("ply\nformat ascii 1.0\ncomment {}\nelement vertex {}\n", comment, mesh.vertices.size());
  for (const char* axis : {"x", "y", "z"}) text += fmt::format("property double {}\n", axis);
  if (coloured) text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  for (const VertexColumn& column : columns) text += fmt::format("property {} {}\n", column.type, column.name);
  text += fmt::format("element face {}\nproperty list uchar int vertex_indices\n", mesh.triangles.size());
  if (laid) text += "property list uchar float texcoord\nproperty int texnumber\n";
  return text + "end_header\n";
}

/// With as many digits as its type needs.
void write_value(std::string& text, const VertexColumn& column, std::size_t i) {
  const std::string_view type = column.type;
  if (type == "float") {
    fmt::format_to(std::back_inserter(text), FMT_COMPILE(" {}"), static_cast<float>(column.values[i]));
  } else if (type == "double") {
    fmt::format_to(std::back_inserter(text), FMT_COMPILE(" {}"), column.values[i]);
  } else {
    fmt::format_to(std::back_inserter(text), FMT_COMPILE(" {}"), static_cast<long long>(column.values[i]));
  }
}

void write_uvs(std::string& text, const TriangleUvs& uvs) {
  text += " 6";
  for (const auto& [u, v] : uvs.corners) {
    fmt::format_to(std::back_inserter(text), FMT_COMPILE(" {} {}"), static_cast<float>(u), static_cast<float>(v));
  }
  fmt::format_to(std::back_inserter(text), FMT_COMPILE(" {}"), uvs.picture);
}

}  // namespace

void write_ply(const Mesh& mesh, const std::vector<Colour>& colours, const std::vector<VertexColumn>& columns, const std::string& comment,
               const Sink& sink, const std::vector<TriangleUvs>& uvs) {
  std::string text = header(mesh, !colours.empty(), columns, !uvs.empty(), comment);
  const auto out = std::back_inserter(text);
  const auto pass_on = [&](std::size_t least) {
    if (text.size() < least) return;
    sink(text);
    text.clear();
  };
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3& v = mesh.vertices[i];
    fmt::format_to(out, FMT_COMPILE("{} {} {}"), v.x(), v.y(), v.z());
    if (!colours.empty()) fmt::format_to(out, FMT_COMPILE(" {} {} {}"), colours[i][0], colours[i][1], colours[i][2]);
    for (const VertexColumn& column : columns) write_value(text, column, i);
    text += '\n';
    pass_on(piece);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    fmt::format_to(out, FMT_COMPILE("3 {} {} {}"), a, b, c);
    if (!uvs.empty()) write_uvs(text, uvs[t]);
    text += '\n';
    pass_on(piece);
  }
  pass_on(0);
}

std::string ply_text(const Mesh& mesh, const std::vector<Colour>& colours, const std::vector<VertexColumn>& columns,
                     const std::string& comment) {
  return text_of([&](const Sink& sink) { write_ply(mesh, colours, columns, comment, sink); });
}

}  // namespace homolog
