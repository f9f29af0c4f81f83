// SPDX-License-Identifier: MIT
#include "homolog/outputs/attributes_ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "homolog/outputs/ply.h"
#include "homolog/outputs/specimen.h"

namespace homolog {
namespace {

double byte_of(float share) { return std::round(255 * std::clamp(share, 0.0f, 1.0f)); }

VertexColumn column_of(const Field& field) {
  if (field.kind == Field::Kind::value) return {field.name, field.values, "double"};
  VertexColumn column{field.name, field.values, "int"};
  for (double& label : column.values) {
    if (std::isnan(label)) label = field.no_label;
    if (std::abs(label) > 2147483647) column.type = "double";
  }
  return column;
}

}  // namespace

std::string attributes_ply(const AttributedMesh& mesh, const std::vector<DensePlace>& places, const std::string& from) {
  std::vector<Colour> colours;
  VertexColumn alpha{"alpha", {}, "uchar"}, carried{"carried", {}, "uchar"};
  for (const Rgba& colour : mesh.colours) {
    colours.push_back({});
    for (int k = 0; k < 3; ++k) colours.back()[k] = static_cast<std::uint8_t>(byte_of(colour[k]));
    alpha.values.push_back(byte_of(colour[3]));
  }
  for (const DensePlace& place : places) carried.values.push_back(place.is_there() ? 1 : 0);
  std::vector<VertexColumn> columns;
  if (std::any_of(alpha.values.begin(), alpha.values.end(), [](double value) { return value < 255; })) columns.push_back(alpha);
  for (const Field& field : mesh.fields) {
    if (field.name != carried.name) columns.push_back(column_of(field));  // of an earlier transfer
  }
  columns.push_back(carried);
  std::string comment = fmt::format("carried from {}; where 'carried' is 0 values are nan", one_line(from));
  for (const Field& field : mesh.fields) {
    if (field.kind == Field::Kind::label) comment += fmt::format(", '{}' {}", field.name, field.no_label);
  }
  return ply_text(mesh.mesh, colours, columns, comment);
}

}  // namespace homolog
