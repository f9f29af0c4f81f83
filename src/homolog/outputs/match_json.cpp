// SPDX-License-Identifier: MIT
// The formats key by key, in the order in which the files show them.
#include "homolog/outputs/match_json.h"

#include "homolog/outputs/json_text.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;

ordered_json to_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

ordered_json to_json(const std::vector<Vec3>& list) {
  ordered_json array = ordered_json::array();
  for (const Vec3& v : list) array.push_back(to_json(v));
  return array;
}

template <class Matrix>
ordered_json rows_to_json(const Matrix& matrix) {
  ordered_json rows = ordered_json::array();
  for (int i = 0; i < matrix.rows(); ++i) {
    ordered_json row = ordered_json::array();
    for (int j = 0; j < matrix.cols(); ++j) row.push_back(matrix(i, j));
    rows.push_back(std::move(row));
  }
  return rows;
}

ordered_json to_json(const Params& params) {
  ordered_json object = ordered_json::object();
  for (const ParameterInfo& info : parameter_table()) {
    std::visit([&](const auto& value) { object[info.name] = value; }, get_parameter(params, info.name));
  }
  return object;
}

ordered_json to_json(const SalientPoint& point) {
  const Vec3 direction = point.direction_length > 0 ? point.direction : Vec3::Zero();
  return {{"position", to_json(point.position)}, {"radius", point.radius}, {"direction", to_json(direction)}, {"response", point.response}};
}

ordered_json to_json(const Shape& shape, const std::vector<SalientPoint>& followed = {}) {
  ordered_json points = ordered_json::array();
  for (const SalientPoint& point : shape.points) points.push_back(to_json(point));
  for (const SalientPoint& point : followed) points.push_back(to_json(point));
  ordered_json json = {{"file", shape.name}};
  if (shape.ras) json["coordinate_system"] = "RAS";
  json["diagonal"] = shape.diagonal;
  json["points"] = std::move(points);
  return json;
}

ordered_json to_json(const StageCounts& counts) {
  ordered_json object = ordered_json::object();
  for (const auto& [stage, count] : counts.stages) object[stage] = count;
  return object;
}

ordered_json to_json(const Correspondence& pair) {
  return {{"model", pair.model}, {"data", pair.data}, {"descriptor_distance", pair.descriptor_distance}, {"confidence", pair.confidence}};
}

ordered_json to_json(const ThinPlateSpline& warp) {
  return {{"kernel", warp.kernel == Kernel::r ? "r" : "r3"},
          {"centres", to_json(warp.centres)},
          {"weights", to_json(warp.weights)},
          {"affine", rows_to_json(warp.affine)}};
}

ordered_json to_json(const Match& match) {
  ordered_json pairs = ordered_json::array();
  for (const Correspondence& pair : match.pairs) pairs.push_back(to_json(pair));
  return {{"pairs", std::move(pairs)},
          {"confidence", match.confidence},
          {"handedness", handedness_name(match.handedness)},
          {"scale", match.similarity.scale},
          {"data_from_model", rows_to_json(match.similarity.matrix())},
          {"bending", match.bending},
          {"chamfer", match.chamfer},
          {"model_coverage", match.model_coverage},
          {"data_coverage", match.data_coverage},
          {"warp", to_json(match.data_from_model)}};
}

ordered_json head(const char* format, const Params& params) {
  ordered_json json = json_head(format);
  json["parameters"] = to_json(params);
  return json;
}

}  // namespace

std::string match_json(const Shape& model, const Shape& data, const Family& family, const Params& params) {
  ordered_json json = head("homolog-match", params);
  json["model"] = to_json(model);
  json["data"] = to_json(data, family.followed);
  json["counts"] = to_json(family.counts);
  json["matches"] = ordered_json::array();
  for (const Match& match : family.matches) json["matches"].push_back(to_json(match));
  return json_text(json);
}

std::string points_json(const Shape& shape, const Params& params) {
  ordered_json json = head("homolog-points", params);
  json["shape"] = to_json(shape);
  return json_text(json);
}

}  // namespace homolog
