// SPDX-License-Identifier: MIT
#include "homolog/outputs/dense_files.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "homolog/outputs/json_text.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;

constexpr Colour no_place = {128, 128, 128};
constexpr double darkest = 40, brightest = 255;

ordered_json direction_json(const std::string& from, const std::string& to, const DenseMap& map) {
  return {{"from", from},
          {"to", to},
          {"vertices", map.places.size()},
          {"placed", map.placed},
          {"torn_edges", map.torn},
          {"triangles", map.triangles},
          {"folded_triangles", map.folded}};
}

}  // namespace

std::string dense_csv(const DenseMap& map) {
  std::string text = "vertex,triangle,b0,b1,b2,x,y,z,confidence\n";
  auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < map.places.size(); ++i) {
    const DensePlace& place = map.places[i];
    const Vec3 &b = place.barycentric, &x = place.position;
    if (place.is_there()) {
      fmt::format_to(out, "{},{},{},{},{},{},{},{},{:.4f}\n", i, place.triangle, b[0], b[1], b[2], x[0], x[1], x[2], place.confidence);
    } else {
      fmt::format_to(out, "{},,,,,,,,0\n", i);
    }
  }
  return text;
}

std::vector<Colour> position_colours(const Mesh& mesh) {
  const Box box = bounding_box(mesh);
  const Vec3 sides = box.max - box.min;
  std::vector<Colour> colours;
  for (const Vec3& vertex : mesh.vertices) {
    colours.push_back({});
    for (int k = 0; k < 3; ++k) {
      const double share = sides[k] > 0 ? std::clamp((vertex[k] - box.min[k]) / sides[k], 0.0, 1.0) : 0;
      colours.back()[k] = static_cast<std::uint8_t>(std::lround(darkest + share * (brightest - darkest)));
    }
  }
  return colours;
}

std::vector<Colour> carried_colours(const DenseMap& map, const Mesh& other, const std::vector<Colour>& colours) {
  std::vector<Colour> carried;
  for (const DensePlace& place : map.places) {
    carried.push_back(no_place);
    if (!place.is_there()) continue;
    for (int channel = 0; channel < 3; ++channel) {
      double value = 0;
      for (int k = 0; k < 3; ++k) value += place.barycentric[k] * colours[other.triangles[place.triangle][k]][channel];
      carried.back()[channel] = static_cast<std::uint8_t>(std::lround(value));
    }
  }
  return carried;
}

std::string dense_ply(const Mesh& mesh, const DenseMap& map, const std::vector<Colour>& colours) {
  std::vector<VertexColumn> columns{{"place_x", {}}, {"place_y", {}}, {"place_z", {}}, {"quality", {}}};
  for (const DensePlace& place : map.places) {
    for (int k = 0; k < 3; ++k) {
      columns[k].values.push_back(place.is_there() ? static_cast<float>(place.position[k]) : std::numeric_limits<float>::quiet_NaN());
    }
    columns[3].values.push_back(static_cast<float>(place.confidence));
  }
  return ply_text(mesh, colours, columns, "place: the vertex on the other mesh; quality: confidence, 0 to 1");
}

std::string dense_json(const StoredFamily& family, int match, const DenseMaps& maps) {
  ordered_json json = json_head("homolog-dense");
  json["match"] = match;
  json["data_from_model"] = direction_json(family.model.file, family.data.file, maps.data_from_model);
  json["model_from_data"] = direction_json(family.data.file, family.model.file, maps.model_from_data);
  return json_text(json);
}

}  // namespace homolog
