// SPDX-License-Identifier: MIT
#include "homolog/shape/read_ply_attributes.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "homolog/shape/find_picture.h"
#include "homolog/shape/ply_faces.h"
#include "homolog/shape/read_ply.h"

namespace homolog {
namespace {

/// Files of pictures, as MeshLab and others name them in comments.
std::vector<std::string> pictures_of(const PlyHeader& header) {
  std::vector<std::string> names;
  for (std::string_view comment : header.comments) {
    if (take_word(comment) != "TextureFile") continue;
    names.push_back(rest_of(comment));
    std::replace(names.back().begin(), names.back().end(), '\\', '/');
  }
  return names;
}

/// Takes the columns of UVs away, as different programs call them, and lays the triangles by them on the first of `count` pictures;
/// vertices on seams stand twice in the file.
Texturing lay_by_vertices(PlyColumns& columns, const Mesh& mesh, std::size_t count) {
  static const std::pair<const char*, const char*> names[] = {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}};
  const auto has = [&](const char* name) {
    return std::any_of(columns.begin(), columns.end(), [&](const PlyColumn& column) { return column.name == name; });
  };
  const auto known = [](double x) { return std::isfinite(x) ? x : 0; };
  Texturing texturing;
  for (const auto& [u, v] : names) {
    if (!has(u) || !has(v)) continue;
    const PlyColumn along = take_column(columns, u), up = take_column(columns, v);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) texturing.uvs.push_back({known(along.values[i]), known(up.values[i])});
    texturing.corners = mesh.triangles;
    texturing.material_of.assign(mesh.triangles.size(), count > 0 ? 0 : -1);
    break;
  }
  return texturing;
}

/// Materials of the pictures and nothing else.
void add_pictures(AttributedMesh& mesh, const std::vector<std::string>& pictures, const FindOther& find_other) {
  if (mesh.texturing.uvs.empty()) {
    for (const std::string& picture : pictures) mesh.left_out.push_back(shown(picture, longest_name) + ", as no UVs say where it lies");
    return;
  }
  PictureNumbers numbers;
  std::vector<Material>& materials = mesh.texturing.materials;
  for (const std::string& picture : pictures) {
    const int image = find_picture(picture, find_other, mesh.texturing.images, numbers, {mesh.missing, mesh.left_out});
    materials.push_back({free_name(materials, std::filesystem::path(picture).stem().string()), {1, 1, 1, 1}, image});
  }
}

/// Lists of faces that are not read.
std::string told_lists(const PlyElement& faces) {
  std::string names;
  for (const PlyProperty& property : faces.properties) {
    const bool is_read = property.count_type == NumberType::none || property.name.starts_with("vertex_ind") || property.name == "texcoord";
    if (!is_read) names += (names.empty() ? "" : ", ") + shown(property.name);
  }
  return names;
}

}  // namespace

AttributedMesh read_ply_attributes(std::string_view content, const std::string& file, const FindOther& find_other) {
  AttributedMesh mesh;
  mesh.mesh = read_ply(content, file);
  PlySource source = open_ply(content, file);
  PlyColumns vertices;
  PlyFaces faces;
  for (const PlyElement& element : source.header.elements) {
    if (element.name == "vertex") {
      vertices = read_columns(source, element);
    } else if (element.name == "face" && element.properties.size() > 1 && !mesh.mesh.triangles.empty()) {
      faces = read_ply_faces(source, element, mesh.mesh);
      if (const std::string told = told_lists(element); !told.empty()) mesh.left_out.push_back(told + " of its faces");
    } else {
      skip_elements(source, element);
    }
  }
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) take_column(vertices, name);
  mesh.colours = take_colours(vertices);
  const std::vector<std::string> pictures = pictures_of(source.header);
  mesh.texturing = lay_by_vertices(vertices, mesh.mesh, pictures.size());
  if (!faces.uvs.name.empty()) mesh.texturing = lay_by_faces(faces, mesh.mesh, pictures.size());
  add_pictures(mesh, pictures, find_other);
  for (PlyColumn& column : vertices) {
    mesh.fields.push_back({column.name, is_whole(column.type) ? Field::Kind::label : Field::Kind::value, std::move(column.values)});
  }
  give_to_vertices(faces, mesh);
  return mesh;
}

}  // namespace homolog
