// SPDX-License-Identifier: MIT
#include "homolog/outputs/attributes_ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "homolog/outputs/pictures.h"
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

/// The pictures that materials have, in the order in which comments name them, and which of these each material has; -1: none.
struct Pictures {
  std::vector<int> images, of_materials;
};

Pictures pictures_of(const Texturing& texturing) {
  Pictures pictures;
  for (const Material& material : texturing.materials) {
    const auto image = std::find(pictures.images.begin(), pictures.images.end(), material.image);
    pictures.of_materials.push_back(material.image < 0 ? -1 : static_cast<int>(image - pictures.images.begin()));
    if (material.image >= 0 && image == pictures.images.end()) pictures.images.push_back(material.image);
  }
  return pictures;
}

std::vector<TriangleUvs> uvs_of_triangles(const Texturing& texturing, const Pictures& pictures) {
  std::vector<TriangleUvs> triangles(texturing.corners.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!texturing.has_uvs(t)) continue;
    for (int k = 0; k < 3; ++k) triangles[t].corners[k] = texturing.uvs[texturing.corners[t][k]];
    if (texturing.material_of[t] >= 0) triangles[t].picture = pictures.of_materials[texturing.material_of[t]];
  }
  return triangles;
}

/// The columns s and t; none if a corner has no UVs or other ones than the same vertex in another triangle, or if a picture must be told.
std::vector<VertexColumn> uvs_of_vertices(const AttributedMesh& mesh, const std::vector<TriangleUvs>& triangles) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<Uv> uvs(mesh.mesh.vertices.size(), Uv{none, none});
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!mesh.texturing.has_uvs(t) || triangles[t].picture != triangles[0].picture) return {};
    for (int k = 0; k < 3; ++k) {
      Uv& uv = uvs[mesh.mesh.triangles[t][k]];
      if (std::isnan(uv[0])) uv = triangles[t].corners[k];
      if (uv != triangles[t].corners[k]) return {};
    }
  }
  std::vector<VertexColumn> columns{{"s", {}}, {"t", {}}};
  for (const Uv& uv : uvs) {
    for (int axis = 0; axis < 2; ++axis) columns[axis].values.push_back(std::isnan(uv[axis]) ? 0 : uv[axis]);
  }
  return columns;
}

std::string comment_of(const AttributedMesh& mesh, const Pictures& pictures, const std::filesystem::path& out, const std::string& from) {
  std::string comment = fmt::format("carried from {}; where 'carried' is 0 values are nan", one_line(from));
  for (const Field& field : mesh.fields) {
    if (field.kind == Field::Kind::label) comment += fmt::format(", '{}' {}", field.name, field.no_label);
  }
  for (const int image : pictures.images) comment += "\ncomment TextureFile " + picture_name(out, mesh.texturing.images[image]);
  return comment;
}

}  // namespace

std::vector<OutputFile> attributes_ply(const AttributedMesh& mesh, const std::vector<DensePlace>& places, const std::filesystem::path& out,
                                       const std::string& from) {
  std::vector<Colour> colours;
  VertexColumn alpha{"alpha", {}, "uchar"}, carried{"carried", {}, "uchar"};
  for (const Rgba& colour : mesh.colours) {
    colours.push_back({});
    for (int k = 0; k < 3; ++k) colours.back()[k] = static_cast<std::uint8_t>(byte_of(colour[k]));
    alpha.values.push_back(byte_of(colour[3]));
  }
  for (const DensePlace& place : places) carried.values.push_back(place.is_there() ? 1 : 0);
  const Pictures pictures = pictures_of(mesh.texturing);
  std::vector<TriangleUvs> uvs;
  if (!mesh.texturing.uvs.empty()) uvs = uvs_of_triangles(mesh.texturing, pictures);
  std::vector<VertexColumn> columns;
  if (!uvs.empty()) columns = uvs_of_vertices(mesh, uvs);
  if (!columns.empty()) uvs.clear();
  if (std::any_of(alpha.values.begin(), alpha.values.end(), [](double value) { return value < 255; })) columns.push_back(alpha);
  for (const Field& field : mesh.fields) {
    if (field.name != carried.name) columns.push_back(column_of(field));  // of an earlier transfer
  }
  columns.push_back(carried);
  const std::string comment = comment_of(mesh, pictures, out, from);
  const auto write = [&](const Sink& sink) { write_ply(mesh.mesh, colours, columns, comment, sink, uvs); };
  std::vector<OutputFile> files = picture_files(mesh.texturing, out);
  files.insert(files.begin(), OutputFile{out, text_of(write)});
  return files;
}

bool ply_leaves_out(const Texturing& texturing) {
  const auto is_more = [](const Material& material) { return material.image < 0 || material.colour != Rgba{1, 1, 1, 1}; };
  return !texturing.gltf.empty() || std::any_of(texturing.materials.begin(), texturing.materials.end(), is_more);
}

}  // namespace homolog
