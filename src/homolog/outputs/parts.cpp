// SPDX-License-Identifier: MIT
#include "homolog/outputs/parts.h"

#include <fmt/format.h>

#include <cmath>

#include "homolog/outputs/json_text.h"
#include "homolog/outputs/ply.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;

const Vec3 surface_colour(204, 212, 219), part_colour(51, 168, 158);  // as in the report

/// To three digits.
std::string weights_json(const std::vector<float>& weights, std::size_t indent) {
  static const std::vector<std::string> texts = [] {
    std::vector<std::string> list;
    for (int k = 0; k <= 1000; ++k) list.push_back(ordered_json(k / 1000.0).dump());
    return list;
  }();
  const auto text = [&](std::size_t i) { return texts[static_cast<std::size_t>(std::lround(1000 * static_cast<double>(weights[i])))]; };
  return json_list(weights.size(), text, indent);
}

/// `indent`: of the line that it stands on.
void write_weights(const PartWeights& part, std::size_t indent, const Sink& sink) {
  sink(fmt::format("{{\n{:{}}\"vertices\": ", "", indent + 1));
  sink(weights_json(part.vertices, indent + 1));
  sink(fmt::format(",\n{:{}}\"samples\": ", "", indent + 1));
  sink(weights_json(part.samples, indent + 1));
  sink(fmt::format("\n{:{}}}}", "", indent));
}

ordered_json place_json(const Vec3& x) { return {x.x(), x.y(), x.z()}; }

ordered_json side_json(const MeshedShape& side, const std::optional<Box>& box) {
  ordered_json json{{"file", side.shape.name}, {"vertices", side.mesh.vertices.size()}};
  if (box) json["box"] = {place_json(box->min), place_json(box->max)};
  ordered_json& samples = json["samples"] = ordered_json::array();
  for (const SurfaceSample& s : side.shape.surface) samples.push_back(place_json(s.position));
  return json;
}

}  // namespace

void write_parts_json(const MeshedShape& model, const MeshedShape& data, const std::vector<MatchParts>& parts, const Sink& sink) {
  sink("{\n");
  const nlohmann::ordered_json head = json_head("homolog-parts");
  for (const auto& [key, value] : head.items()) sink(fmt::format(" \"{}\": {},\n", key, value.dump()));
  const auto box_of = [&](PartWeights MatchParts::*side) { return parts.empty() ? std::nullopt : (parts[0].*side).box; };
  sink(" \"model\": " + json_piece(side_json(model, box_of(&MatchParts::model)), 1) + ",\n");
  sink(" \"data\": " + json_piece(side_json(data, box_of(&MatchParts::data)), 1) + ",\n \"matches\": [");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    sink(i > 0 ? ",\n  {\n   \"model\": " : "\n  {\n   \"model\": ");
    write_weights(parts[i].model, 3, sink);
    sink(",\n   \"data\": ");
    write_weights(parts[i].data, 3, sink);
    sink("\n  }");
  }
  sink(parts.empty() ? "]\n}\n" : "\n ]\n}\n");
}

void write_part_ply(const Mesh& mesh, const std::vector<float>& weights, const Sink& sink) {
  std::vector<Colour> colours;
  for (const float weight : weights) {
    const Vec3 mixed = surface_colour + weight * (part_colour - surface_colour);
    colours.push_back({});
    for (int k = 0; k < 3; ++k) colours.back()[k] = static_cast<std::uint8_t>(std::lround(mixed[k]));
  }
  write_ply(mesh, colours, {{"quality", std::vector<double>(weights.begin(), weights.end())}},
            "quality: weight of the covered part, 0 to 1", sink);
}

}  // namespace homolog
