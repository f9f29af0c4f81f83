// SPDX-License-Identifier: MIT
#include "homolog/shape/read_ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "homolog/shape/ply_values.h"
#include "homolog/shape/polygon.h"

namespace homolog {
namespace {

void read_vertices(PlySource& source, const PlyElement& element, Mesh& mesh) {
  std::vector<int> axes;
  for (const PlyProperty& property : element.properties) {
    const bool axis =
        property.count_type == NumberType::none && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z';
    axes.push_back(axis ? property.name[0] - 'x' : -1);
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (std::count(axes.begin(), axes.end(), axis) != 1) fail(source.text, "element vertex must have the properties x, y and z once each");
  }
  mesh.vertices.resize(element.count);
  for (std::size_t i = 0; i < element.count; ++i) {
    begin_element(source, element, i);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      if (axes[k] < 0) {
        skip_property(source, element.properties[k]);
      } else if (!std::isfinite(mesh.vertices[i][axes[k]] = read_ply_value(source, element.properties[k].type))) {
        fail_at(source, "a coordinate is not a finite number; the file is damaged");
      }
    }
  }
}

bool are_corners(const PlyProperty& property) {
  return property.count_type != NumberType::none && (property.name == "vertex_indices" || property.name == "vertex_index");
}

void read_faces(PlySource& source, const PlyElement& element, Mesh& mesh) {
  if (element.count > 0 && mesh.vertices.empty()) {
    fail(source.text, "the faces stand before the vertices, which is not read; save it with the vertices first");
  }
  if (element.count > 0 && std::none_of(element.properties.begin(), element.properties.end(), are_corners)) {
    fail(source.text, "the faces have no list vertex_indices; name the list of their corners so in the header, or export it again");
  }
  for (std::size_t i = 0; i < element.count; ++i) {
    begin_element(source, element, i);
    for (const PlyProperty& property : element.properties) {
      if (!are_corners(property)) {
        skip_property(source, property);
        continue;
      }
      std::vector<std::uint32_t> corners(read_length(source, property));
      for (std::uint32_t& corner : corners) {
        const double index = read_ply_value(source, property.type);
        if (!(index >= 0 && index < static_cast<double>(mesh.vertices.size())) || index != std::floor(index)) {
          fail_at(source, fmt::format("vertex {} does not exist (the file has {}, counted from 0); the file is damaged", index,
                                      mesh.vertices.size()));
        }
        corner = static_cast<std::uint32_t>(index);
      }
      append_polygon(mesh, std::move(corners));
    }
  }
}

}  // namespace

Mesh read_ply(std::string_view content, const std::string& file) {
  PlySource source = open_ply(content, file);
  Mesh mesh;
  for (const PlyElement& element : source.header.elements) {
    if (element.name == "vertex") {
      if (!mesh.vertices.empty()) fail(source.text, "element vertex is announced twice");
      read_vertices(source, element, mesh);
    } else if (element.name == "face") {
      read_faces(source, element, mesh);
    } else if (element.name == "tristrips" && element.count > 0) {
      fail(source.text, "the triangles stand in strips (element tristrips), which are not read; save it with faces");
    } else {
      skip_elements(source, element);
    }
  }
  return mesh;
}

}  // namespace homolog
