// SPDX-License-Identifier: MIT
#include "homolog/shape/read_ply_attributes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "homolog/shape/ply_values.h"
#include "homolog/shape/read_ply.h"

namespace homolog {
namespace {

/// A single property of all vertices.
struct Column {
  std::string name;
  NumberType type;
  std::vector<double> values;
};

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::vector<Column> read_columns(PlySource& source, const PlyElement& element) {
  std::vector<Column> columns(element.properties.size());
  for (std::size_t k = 0; k < columns.size(); ++k) columns[k] = {element.properties[k].name, element.properties[k].type, {}};
  for (std::size_t i = 0; i < element.count; ++i) {
    begin_element(source, element, i);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (element.properties[k].count_type != NumberType::none) {
        skip_property(source, element.properties[k]);
      } else {
        const double value = read_loose_value(source, columns[k].type);
        columns[k].values.push_back(std::isfinite(value) ? value : none);
      }
    }
  }
  std::erase_if(columns, [](const Column& column) { return column.values.empty(); });
  return columns;
}

bool is_whole(NumberType type) { return type < NumberType::float32; }

double largest(NumberType type) {
  switch (type) {
    case NumberType::uint8:
      return 255;
    case NumberType::uint16:
      return 65535;
    case NumberType::int8:
      return 127;
    case NumberType::int16:
      return 32767;
    case NumberType::int32:
      return 2147483647;
    case NumberType::uint32:
      return 4294967295;
    default:
      return 1;
  }
}

/// Takes the columns of colour away and returns what they say; nothing when red, green and blue are not all there.
std::vector<Rgba> take_colours(std::vector<Column>& columns) {
  static const std::string names[] = {"red", "green", "blue", "alpha"};
  const auto is_colour = [](const Column& column) { return std::find(std::begin(names), std::end(names), column.name) != std::end(names); };
  std::vector<Rgba> colours;
  int channels = 0;
  for (int channel = 0; channel < 4; ++channel) {
    const auto column = std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == names[channel]; });
    if (column == columns.end()) continue;
    colours.resize(column->values.size(), Rgba{0, 0, 0, 1});
    channels += channel < 3;
    for (std::size_t i = 0; i < colours.size(); ++i) {
      const double share = column->values[i] / largest(column->type);
      colours[i][channel] = static_cast<float>(std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0);
    }
  }
  if (channels < 3) return {};
  std::erase_if(columns, is_colour);
  return colours;
}

bool is_geometry(const Column& column) {
  static const std::string names[] = {"x", "y", "z", "nx", "ny", "nz"};
  return std::find(std::begin(names), std::end(names), column.name) != std::end(names);
}

/// Takes the columns of UVs away, as different programs call them, and lays the triangles by them; vertices on seams stand twice in the
/// file.
Texturing take_uvs(std::vector<Column>& columns, const Mesh& mesh) {
  static const std::pair<const char*, const char*> names[] = {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}};
  const auto find = [&](const char* name) {
    return std::find_if(columns.begin(), columns.end(), [&](const Column& column) { return column.name == name; });
  };
  const auto known = [](double x) { return std::isfinite(x) ? x : 0; };
  Texturing texturing;
  for (const auto& [u, v] : names) {
    const auto along = find(u), up = find(v);
    if (along == columns.end() || up == columns.end()) continue;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) texturing.uvs.push_back({known(along->values[i]), known(up->values[i])});
    texturing.corners = mesh.triangles;
    texturing.material_of.assign(mesh.triangles.size(), -1);
    std::erase_if(columns, [&, first = u, second = v](const Column& column) { return column.name == first || column.name == second; });
    break;
  }
  return texturing;
}

/// What faces say beside their corners, by name.
std::string told_face_properties(const PlyElement& faces) {
  std::string names;
  for (const PlyProperty& property : faces.properties) {
    if (!property.name.starts_with("vertex_ind")) names += (names.empty() ? "" : ", ") + shown(property.name);
  }
  return names;
}

}  // namespace

AttributedMesh read_ply_attributes(std::string_view content, const std::string& file) {
  AttributedMesh mesh;
  mesh.mesh = read_ply(content, file);
  PlySource source = open_ply(content, file);
  for (const PlyElement& element : source.header.elements) {
    const std::string told = element.name == "face" ? told_face_properties(element) : "";
    if (!told.empty()) mesh.left_out.push_back(told + " of its faces; give it to the vertices");
  }
  for (const PlyElement& element : source.header.elements) {
    if (element.name != "vertex") {
      skip_elements(source, element);
      continue;
    }
    std::vector<Column> columns = read_columns(source, element);
    std::erase_if(columns, is_geometry);
    mesh.colours = take_colours(columns);
    mesh.texturing = take_uvs(columns, mesh.mesh);
    for (Column& column : columns) {
      mesh.fields.push_back({column.name, is_whole(column.type) ? Field::Kind::label : Field::Kind::value, std::move(column.values)});
    }
    break;
  }
  return mesh;
}

}  // namespace homolog
