// SPDX-License-Identifier: MIT
// Meshes as PLY text, the form that every program of the trade reads, R's geomorph included.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "homolog/outputs/sink.h"
#include "homolog/shape/mesh.h"

namespace homolog {

/// What a PLY says of every vertex beside its place; `values` as many as vertices. `type`: float, double, int or uchar; the values fit.
struct VertexColumn {
  std::string name;
  std::vector<double> values;
  const char* type = "float";
};

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue

/// PLY 1.0 in ASCII: vertices in their order with all digits, colours unless there are none, columns as properties, triangles.
/// `comment` is one line.
void write_ply(const Mesh& mesh, const std::vector<Colour>& colours, const std::vector<VertexColumn>& columns, const std::string& comment,
               const Sink& sink);
std::string ply_text(const Mesh& mesh, const std::vector<Colour>& colours, const std::vector<VertexColumn>& columns,
                     const std::string& comment);

}  // namespace homolog
