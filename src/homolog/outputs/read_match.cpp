// SPDX-License-Identifier: MIT
#include "homolog/outputs/read_match.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "homolog/base/errors.h"
#include "homolog/base/read_file.h"
#include "homolog/outputs/json_text.h"
#include "homolog/outputs/read_warp.h"
#include "homolog/outputs/symmetry_text.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;

constexpr const char* no_pairs = "a match has no pairs of points; the file is damaged";

double read_share(const ordered_json& value, const char* what, const std::string& file) {
  const double share = value;
  if (!(share >= 0 && share <= 1)) fail(file, fmt::format("{} is not from 0 to 1; the file is damaged", what));
  return share;
}

Vec3 read_place(const ordered_json& shape, const ordered_json& number, const std::string& file) {
  return read_vector(shape.at("points").at(read_whole_number(number, file)).at("position"), file);
}

/// Refuses a warp that leads a pair apart: wherever a warp leads a point, the place is no farther from the point's partner than the data is
/// large.
void check_pair(const ThinPlateSpline& warp, const Vec3& model, const Vec3& data, double diagonal, const std::string& file) {
  if ((warp(model) - data).norm() <= diagonal) return;
  fail(file, "the warp of a match leads a pair of its points apart; the file is damaged");
}

/// The model's points of the pairs of a match.
std::vector<KnownPlace> read_known(const ordered_json& match, const ordered_json& model, const ordered_json& data,
                                   const ThinPlateSpline& warp, const std::string& file) {
  std::vector<KnownPlace> known;
  if (match.at("pairs").empty()) fail(file, no_pairs);
  for (const ordered_json& pair : match.at("pairs")) {
    const Vec3 position = read_place(model, pair.at("model"), file);
    known.push_back({position, read_share(pair.at("confidence"), "the confidence of a pair", file)});
    check_pair(warp, position, read_place(data, pair.at("data"), file), data.at("diagonal"), file);
  }
  return known;
}

bool states_ras(const ordered_json& shape) { return shape.value("coordinate_system", "") == "RAS"; }

/// That of a map, which must not mirror what is told to be proper, or the other way round.
Handedness read_handedness(const ordered_json& name, const Mat3& turn, const std::string& file) {
  for (const Handedness handedness : {Handedness::proper, Handedness::mirrored, Handedness::ambiguous}) {
    if (name != handedness_name(handedness)) continue;
    if (handedness != Handedness::ambiguous && (handedness == Handedness::mirrored) != (turn.determinant() < 0))
      fail(file, fmt::format("a match is told to be {}, but its map is not; the file is damaged", handedness_name(handedness)));
    return handedness;
  }
  fail(file, fmt::format("the handedness {} is not known; use a newer homolog", shown_value(name)));
}

StoredFamily read_matches(const ordered_json& json, const std::string& file) {
  check_head(json, "homolog-match", file);
  const ordered_json &model = json.at("model"), &data = json.at("data");
  StoredFamily family{{model.at("file"), states_ras(model)}, {data.at("file"), states_ras(data)}, {}};
  for (const ordered_json& item : json.at("matches")) {
    MatchMap match;
    match.data_from_model = read_warp(item.at("warp"), file);
    match.known = read_known(item, model, data, match.data_from_model, file);
    match.scale = item.at("scale");
    match.similarity = read_matrix(item.at("data_from_model"));
    match.model_diagonal = model.at("diagonal");
    match.data_diagonal = data.at("diagonal");
    match.confidence = read_share(item.at("confidence"), "the confidence of a match", file);
    match.thickness = json.value("parameters", ordered_json::object()).value("thicken", 0.0);
    if (!(match.scale > 0 && match.model_diagonal > 0 && match.data_diagonal > 0))
      fail(file, "a size is not positive; the file is damaged");
    read_handedness(item.at("handedness"), match.similarity.topLeftCorner<3, 3>(), file);
    if (!(std::abs((match.similarity.topLeftCorner<3, 3>() / match.scale).determinant()) > 0.5))
      fail(file, "a map is no similarity of its scale; the file is damaged");
    family.matches.push_back(std::move(match));
  }
  return family;
}

std::vector<float> read_weights(const ordered_json& list, std::size_t count, const std::string& file) {
  if (list.size() != count) fail(file, "there are not as many weights as vertices or samples; the file is damaged");
  std::vector<float> weights;
  for (const ordered_json& weight : list) weights.push_back(static_cast<float>(read_share(weight, "a weight", file)));
  return weights;
}

std::optional<Box> read_box(const ordered_json& side, const std::string& file) {
  if (!side.contains("box")) return {};
  const std::vector<Vec3> ends = read_vectors(side.at("box"), file);
  if (ends.size() != 2 || !(ends[0].array() <= ends[1].array()).all())
    fail(file, "a box has no least and greatest place; the file is damaged");
  return Box{ends[0], ends[1]};
}

CoveredSamples read_samples(const ordered_json& side, const ordered_json& weights, const std::string& file) {
  std::vector<Vec3> positions = read_vectors(side.at("samples"), file);
  const std::size_t count = positions.size();
  return {std::move(positions), read_weights(weights.at("samples"), count, file), read_box(side, file)};
}

void check_parts(const ordered_json& json, const std::string& file, const std::string& model, const std::string& data, std::size_t count) {
  check_head(json, "homolog-parts", file);
  if (json.at("model").at("file") != model || json.at("data").at("file") != data || json.at("matches").size() != count) {
    fail(file, "it belongs to another match.json than the one beside it; run 'homolog match --out' again or take it away");
  }
}

void add_parts(const ordered_json& json, const std::string& file, StoredFamily& family) {
  check_parts(json, file, family.model.file, family.data.file, family.matches.size());
  const ordered_json &model = json.at("model"), &data = json.at("data"), &matches = json.at("matches");
  for (std::size_t i = 0; i < matches.size(); ++i) {
    family.matches[i].model = read_samples(model, matches[i].at("model"), file);
    family.matches[i].data = read_samples(data, matches[i].at("data"), file);
  }
  family.model.vertices = read_whole_number(model.at("vertices"), file);
  family.data.vertices = read_whole_number(data.at("vertices"), file);
  family.parts_known = true;
}

SalientPoint read_point(const ordered_json& json, const std::string& file) {
  SalientPoint point;
  point.position = read_vector(json.at("position"), file);
  point.radius = json.at("radius");
  point.response = json.at("response");
  const Vec3 direction = read_vector(json.at("direction"), file);
  if (direction.isZero(0)) return point;
  point.direction = direction;
  point.direction_length = 1;  // the file tells that there is one, not how far it can be trusted
  return point;
}

Shape read_shape(const ordered_json& json, const std::string& file) {
  Shape shape;
  shape.name = json.at("file");
  shape.ras = states_ras(json);
  shape.diagonal = json.at("diagonal");
  for (const ordered_json& point : json.at("points")) shape.points.push_back(read_point(point, file));
  return shape;
}

Params read_params(const ordered_json& json, const std::string& file) {
  Params params;
  try {
    for (const auto& [name, value] : json.items()) {
      set_parameter(params, name, value.is_string() ? value.get<std::string>() : value.is_structured() ? value.type_name() : value.dump());
    }
  } catch (const ParamError& error) {
    fail(file, shown(error.what(), 200));
  }
  return params;
}

/// The factor that times `scale` is `product` to the last bit, so that what was read is written as it was.
double factor_of(double product, double scale) {
  const double near = product / scale;
  for (const double factor : {std::nextafter(near, -HUGE_VAL), std::nextafter(near, HUGE_VAL)}) {
    if (scale * near != product && scale * factor == product) return factor;
  }
  return near;
}

Similarity read_similarity(const ordered_json& json, const std::string& file) {
  Similarity similarity;
  similarity.scale = json.at("scale");
  if (!(similarity.scale > 0)) fail(file, "a size is not positive; the file is damaged");
  const Mat4 matrix = read_matrix(json.at("data_from_model"));
  similarity.rotation = matrix.topLeftCorner<3, 3>().unaryExpr([&](double x) { return factor_of(x, similarity.scale); });
  if (!similarity.rotation.allFinite()) fail(file, "a turn is not finite; the file is damaged");
  if (!(similarity.rotation * similarity.rotation.transpose()).isIdentity(1e-6) || matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
    fail(file, "a data_from_model is no similarity of that scale; the file is damaged");
  }
  similarity.shift = matrix.topRightCorner<3, 1>();
  return similarity;
}

CorrespondenceSet read_pairs(const ordered_json& list, const Shape& model, const Shape& data, const ThinPlateSpline& warp,
                             const std::string& file) {
  CorrespondenceSet pairs;
  if (list.empty()) fail(file, no_pairs);
  for (const ordered_json& item : list) {
    const std::size_t of_model = read_whole_number(item.at("model"), file), of_data = read_whole_number(item.at("data"), file);
    if (of_model >= model.points.size() || of_data >= data.points.size())
      fail(file, "a pair names a point that is not there; the file is damaged");
    const Correspondence pair{static_cast<int>(of_model),     static_cast<int>(of_data),
                              model.points[of_model],         data.points[of_data],
                              item.at("descriptor_distance"), read_share(item.at("confidence"), "the confidence of a pair", file)};
    check_pair(warp, pair.model_point.position, pair.data_point.position, data.diagonal, file);
    pairs.push_back(pair);
  }
  return pairs;
}

Match read_match(const ordered_json& json, const Shape& model, const Shape& data, const std::string& file) {
  Match match;
  match.data_from_model = read_warp(json.at("warp"), file);
  match.pairs = read_pairs(json.at("pairs"), model, data, match.data_from_model, file);
  match.similarity = read_similarity(json, file);
  match.handedness = read_handedness(json.at("handedness"), match.similarity.rotation, file);
  match.confidence = read_share(json.at("confidence"), "the confidence of a match", file);
  match.bending = json.at("bending");
  match.chamfer = json.at("chamfer");
  match.model_coverage = json.at("model_coverage");
  match.data_coverage = json.at("data_coverage");
  return match;
}

ReadResult read_whole(const ordered_json& json, const std::string& file) {
  check_head(json, "homolog-match", file);
  ReadResult result;
  result.params = read_params(json.at("parameters"), file);
  result.model = read_shape(json.at("model"), file);
  result.data = read_shape(json.at("data"), file);
  if (!(result.model.diagonal > 0 && result.data.diagonal > 0)) fail(file, "a size is not positive; the file is damaged");
  for (const auto& [stage, count] : json.at("counts").items())
    result.family.counts.stages.emplace_back(stage, static_cast<long>(read_whole_number(count, file)));
  for (const ordered_json& match : json.at("matches")) result.family.matches.push_back(read_match(match, result.model, result.data, file));
  return result;
}

void add_whole_parts(const ordered_json& json, const std::string& file, ReadResult& result) {
  check_parts(json, file, result.model.name, result.data.name, result.family.matches.size());
  const ordered_json &model = json.at("model"), &data = json.at("data");
  for (const Vec3& position : read_vectors(model.at("samples"), file)) result.model.surface.push_back({position, Vec3::Zero()});
  for (const Vec3& position : read_vectors(data.at("samples"), file)) result.data.surface.push_back({position, Vec3::Zero()});
  const auto weights = [&](const ordered_json& of, const ordered_json& side, const Shape& shape) -> PartWeights {
    return {read_weights(of.at("vertices"), side.at("vertices"), file), read_weights(of.at("samples"), shape.surface.size(), file),
            read_box(side, file)};
  };
  result.parts.emplace();
  for (const ordered_json& match : json.at("matches")) {
    result.parts->push_back({weights(match.at("model"), model, result.model), weights(match.at("data"), data, result.data)});
  }
}

/// `match` makes of match.json what `parts` adds parts.json to.
template <class Match, class Parts>
auto read_both(const NamedText& match_json, const std::optional<NamedText>& parts_json, const Match& match, const Parts& parts) {
  auto result =
      read_json(match_json.text, match_json.file, "matches", [&](const ordered_json& json) { return match(json, match_json.file); });
  if (parts_json) {
    read_json(parts_json->text, parts_json->file, "covered parts",
              [&](const ordered_json& json) { parts(json, parts_json->file, result); });
  }
  return result;
}

std::optional<NamedText> parts_beside(const std::filesystem::path& match_json) {
  const std::filesystem::path parts = match_json.parent_path() / "parts.json";
  return std::filesystem::exists(parts) ? std::optional(NamedText{read_file(parts), parts.string()}) : std::nullopt;
}

}  // namespace

StoredFamily read_family(const NamedText& match_json, const std::optional<NamedText>& parts_json) {
  return read_both(match_json, parts_json, read_matches, add_parts);
}

ReadResult read_result(const NamedText& match_json, const std::optional<NamedText>& parts_json) {
  return read_both(match_json, parts_json, read_whole, add_whole_parts);
}

StoredFamily read_family(const std::filesystem::path& match_json) {
  const NamedText match{read_file(match_json), match_json.string()};
  return read_family(match, parts_beside(match_json));
}

ReadResult read_result(const std::filesystem::path& match_json) {
  const NamedText match{read_file(match_json), match_json.string()};
  ReadResult result = read_result(match, parts_beside(match_json));
  const std::filesystem::path symmetry = match_json.parent_path() / "symmetry.json";
  if (result.model.name != result.data.name || !std::filesystem::exists(symmetry)) return result;  // of two shapes it is an older one
  result.symmetries = read_symmetries(read_file(symmetry), symmetry.string(), result.family.matches);
  return result;
}

}  // namespace homolog
