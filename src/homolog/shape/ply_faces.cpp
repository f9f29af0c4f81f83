// SPDX-License-Identifier: MIT
#include "homolog/shape/ply_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "homolog/shape/polygon.h"

namespace homolog {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
const std::vector<std::string> lists{"vertex_indices", "vertex_index", "texcoord"};

/// As the triangles of the mesh were cut, face by face.
std::vector<std::uint32_t> faces_of_triangles(const Mesh& mesh, const PlyColumn& corners) {
  Mesh again{mesh.vertices, {}};
  std::vector<std::uint32_t> faces;
  for (std::uint32_t face = 0; face < corners.ends.size(); ++face) {
    const auto list = corners.list(face);
    append_polygon(again, {list.begin(), list.end()});
    faces.resize(again.triangles.size(), face);
  }
  return again.triangles == mesh.triangles ? faces : std::vector<std::uint32_t>{};
}

/// Which vertices lie at which faces, vertex by vertex.
using Contacts = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Contacts contacts_of(const PlyColumn& corners) {
  Contacts contacts;
  for (std::uint32_t face = 0; face < corners.ends.size(); ++face) {
    for (const double vertex : corners.list(face)) contacts.emplace_back(static_cast<std::uint32_t>(vertex), face);
  }
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// The smallest of those that are there as often.
double most_frequent(const std::vector<double>& given) {
  std::vector<double> labels = given;
  std::sort(labels.begin(), labels.end());
  double best = labels[0];
  std::ptrdiff_t most = 0;
  for (auto first = labels.begin(); first != labels.end();) {
    const auto end = std::upper_bound(first, labels.end(), *first);
    if (end - first > most) best = *first;
    most = std::max(most, end - first);
    first = end;
  }
  return best;
}

/// Of the faces' values that are there; NaN where there are none.
std::vector<double> at_vertices(const Contacts& contacts, std::size_t vertices, const std::vector<double>& of_faces,
                                double (*merge)(const std::vector<double>&)) {
  std::vector<double> result(vertices, none), around;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto& [vertex, face] = contacts[i];
    if (!std::isnan(of_faces[face])) around.push_back(of_faces[face]);
    if (i + 1 < contacts.size() && contacts[i + 1].first == vertex) continue;
    if (!around.empty()) result[vertex] = merge(around);
    around.clear();
  }
  return result;
}

std::vector<Rgba> colours_at_vertices(const Contacts& contacts, std::size_t vertices, const std::vector<Rgba>& of_faces) {
  std::vector<Rgba> colours(vertices, Rgba{1, 1, 1, 1});
  for (std::size_t channel = 0; channel < 4; ++channel) {
    std::vector<double> shares;
    for (const Rgba& colour : of_faces) shares.push_back(colour[channel]);
    const std::vector<double> means = at_vertices(contacts, vertices, shares, mean);
    for (std::size_t i = 0; i < vertices; ++i) {
      if (!std::isnan(means[i])) colours[i][channel] = static_cast<float>(means[i]);
    }
  }
  return colours;
}

}  // namespace

PlyFaces read_ply_faces(PlySource& source, const PlyElement& element, const Mesh& mesh) {
  PlyFaces faces;
  faces.others = read_columns(source, element, lists);
  faces.corners = take_column(faces.others, "vertex_indices");
  if (faces.corners.name.empty()) faces.corners = take_column(faces.others, "vertex_index");
  faces.uvs = take_column(faces.others, "texcoord");
  if (faces.uvs.ends.empty()) faces.uvs = {};
  if (!faces.uvs.name.empty()) faces.pictures = take_column(faces.others, "texnumber");
  std::erase_if(faces.others, [](const PlyColumn& column) {
    return !column.ends.empty() || column.name == "nx" || column.name == "ny" || column.name == "nz";
  });
  faces.of_triangles = faces_of_triangles(mesh, faces.corners);
  return faces.of_triangles.empty() ? PlyFaces{} : faces;
}

Texturing lay_by_faces(const PlyFaces& faces, const Mesh& mesh, std::size_t count) {
  Texturing texturing;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t face = faces.of_triangles[t];
    const auto corners = faces.corners.list(face), uvs = faces.uvs.list(face);
    const double picture = faces.pictures.values.empty() ? 0 : faces.pictures.values[face];
    const bool on_picture = picture >= 0 && picture < static_cast<double>(count);
    const bool laid = uvs.size() == 2 * corners.size() &&
                      (on_picture || std::any_of(uvs.begin(), uvs.end(), [](double share) { return share != 0; }));  // as attributes_ply()
    texturing.material_of.push_back(on_picture ? static_cast<int>(picture) : -1);
    texturing.corners.push_back({Texturing::no_uv, Texturing::no_uv, Texturing::no_uv});
    for (int k = 0; k < 3 && laid; ++k) {
      const auto place = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), mesh.triangles[t][k]) - corners.begin());
      const auto known = [](double share) { return std::isnan(share) ? 0 : share; };
      texturing.corners.back()[k] = static_cast<std::uint32_t>(texturing.uvs.size());
      texturing.uvs.push_back({known(uvs[2 * place]), known(uvs[2 * place + 1])});
    }
  }
  return texturing.uvs.empty() ? Texturing{} : texturing;
}

void give_to_vertices(PlyFaces& faces, AttributedMesh& mesh) {
  const std::size_t vertices = mesh.mesh.vertices.size();
  const std::vector<Rgba> colours = take_colours(faces.others);
  if (colours.empty() && faces.others.empty()) return;
  const Contacts contacts = contacts_of(faces.corners);
  const auto leave_out = [&](const std::string& what) { mesh.left_out.push_back(what + " of its faces, as its vertices have their own"); };
  if (!colours.empty() && !mesh.colours.empty()) leave_out("colours");
  if (!colours.empty() && mesh.colours.empty()) mesh.colours = colours_at_vertices(contacts, vertices, colours);
  for (const PlyColumn& column : faces.others) {
    if (std::any_of(mesh.fields.begin(), mesh.fields.end(), [&](const Field& field) { return field.name == column.name; })) {
      leave_out(shown(column.name));
      continue;
    }
    const bool is_label = is_whole(column.type);
    mesh.fields.push_back({column.name, is_label ? Field::Kind::label : Field::Kind::value,
                           at_vertices(contacts, vertices, column.values, is_label ? most_frequent : mean)});
  }
}

}  // namespace homolog
