// SPDX-License-Identifier: MIT
#include "homolog/outputs/ply.h"

#include <fmt/format.h>

#include <iterator>

namespace homolog {
namespace {

std::string header(const Mesh& mesh, bool coloured, const std::vector<VertexColumn>& columns, const std::string& comment) {
  std::string text = fmt::format("ply\nformat ascii 1.0\ncomment {}\nelement vertex {}\n", comment, mesh.vertices.size());
  for (const char* axis : {"x", "y", "z"}) text += fmt::format("property double {}\n", axis);
  if (coloured) text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  for (const VertexColumn& column : columns) text += fmt::format("property float {}\n", column.name);
  return text + fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n", mesh.triangles.size());
}

}  // namespace

std::string ply_text(const Mesh& mesh, const std::vector<Colour>& colours, const std::vector<VertexColumn>& columns,
                     const std::string& comment) {
  std::string text = header(mesh, !colours.empty(), columns, comment);
  auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3& v = mesh.vertices[i];
    fmt::format_to(out, "{} {} {}", v.x(), v.y(), v.z());
    if (!colours.empty()) fmt::format_to(out, " {} {} {}", colours[i][0], colours[i][1], colours[i][2]);
    for (const VertexColumn& column : columns) fmt::format_to(out, " {}", column.values[i]);
    text += '\n';
  }
  for (const auto& [a, b, c] : mesh.triangles) fmt::format_to(out, "3 {} {} {}\n", a, b, c);
  return text;
}

}  // namespace homolog
