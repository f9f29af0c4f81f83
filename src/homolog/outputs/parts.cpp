// SPDX-License-Identifier: MIT
#include "homolog/outputs/parts.h"

#include <cmath>

#include "homolog/outputs/json_text.h"
#include "homolog/outputs/ply.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;

const Vec3 surface_colour(204, 212, 219), part_colour(51, 168, 158);  // as in the report

ordered_json weights_json(const std::vector<float>& weights) {
  ordered_json list = ordered_json::array();
  for (const float weight : weights) list.push_back(std::round(1000 * static_cast<double>(weight)) / 1000);
  return list;
}

ordered_json weights_json(const PartWeights& part) {
  return {{"vertices", weights_json(part.vertices)}, {"samples", weights_json(part.samples)}};
}

ordered_json side_json(const MeshedShape& side) {
  ordered_json samples = ordered_json::array();
  for (const SurfaceSample& s : side.shape.surface) samples.push_back({s.position.x(), s.position.y(), s.position.z()});
  return {{"file", side.shape.name}, {"vertices", side.mesh.vertices.size()}, {"samples", std::move(samples)}};
}

}  // namespace

std::string parts_json(const MeshedShape& model, const MeshedShape& data, const std::vector<MatchParts>& parts) {
  ordered_json json = {{"format", "homolog-parts"}, {"version", 1}, {"program", "homolog " HOMOLOG_VERSION}};
  json["model"] = side_json(model);
  json["data"] = side_json(data);
  json["matches"] = ordered_json::array();
  for (const MatchParts& part : parts) json["matches"].push_back({{"model", weights_json(part.model)}, {"data", weights_json(part.data)}});
  return json_text(json);
}

std::string part_ply(const Mesh& mesh, const std::vector<float>& weights) {
  std::vector<Colour> colours;
  for (const float weight : weights) {
    const Vec3 mixed = surface_colour + weight * (part_colour - surface_colour);
    colours.push_back({});
    for (int k = 0; k < 3; ++k) colours.back()[k] = static_cast<std::uint8_t>(std::lround(mixed[k]));
  }
  return ply_text(mesh, colours, {{"quality", std::vector<double>(weights.begin(), weights.end())}},
                  "quality: weight of the covered part, 0 to 1");
}

}  // namespace homolog
