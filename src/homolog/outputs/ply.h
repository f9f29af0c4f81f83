// SPDX-License-Identifier: MIT
// Meshes as PLY text, the form that every program of the trade reads, R's geomorph included.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "homolog/outputs/sink.h"
#include "homolog/shape/mesh.h"
#include "homolog/shape/texturing.h"

namespace homolog {

/// What a PLY says of every vertex beside its place; `values` as many as vertices. `type`: float, double, int or uchar; the values fit.
struct VertexColumn {
  std::string name;
  std::vector<double> values;
  const char* type = "float";
};

/// Where a triangle lies on a picture; -1: on none.
struct TriangleUvs {
  std::array<Uv, 3> corners = {};
  int picture = -1;
};

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue

/// PLY 1.0 in ASCII: vertices in their order with all digits, colours unless there are none, columns as properties, triangles.
/// `comment` is one line, or several behind "\ncomment ". `uvs`, of every triangle or none, stand in texcoord and texnumber.
void write_ply(const Mesh& mesh, const std::vector<Colour>& colours, const std::vector<VertexColumn>& columns, const std::string& comment,
               const Sink& sink, const std::vector<TriangleUvs>& uvs = {});
std::string ply_text(const Mesh& mesh, const std::vector<Colour>& colours, const std::vector<VertexColumn>& columns,
                     const std::string& comment);

}  // namespace homolog
