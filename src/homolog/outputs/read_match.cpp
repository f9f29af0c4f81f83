// SPDX-License-Identifier: MIT
#include "homolog/outputs/read_match.h"

#include <fmt/format.h>

#include "homolog/base/errors.h"
#include "homolog/base/read_file.h"
#include "homolog/outputs/json_text.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;

[[noreturn]] void fail(const std::string& file, const std::string& what) { throw FileError(fmt::format("{}: {}", file, what)); }

/// A value for a message. Only a plain one is written out: lists may lie in lists deeper than the stack of what writes them.
std::string shown(const ordered_json& value) { return homolog::shown(value.is_structured() ? value.type_name() : value.dump()); }

void check_format(const ordered_json& json, const char* format, const std::string& file) {
  if (json.at("format") != format)
    fail(file, fmt::format("its format is {}, not \"{}\"; name the right file", shown(json["format"]), format));
  if (json.at("version") != 1)
    fail(file, fmt::format("its version is {}, but only 1 is known; use a newer homolog", shown(json["version"])));
}

std::vector<Vec3> read_vectors(const ordered_json& list, const std::string& file) {
  std::vector<Vec3> vectors;
  for (const ordered_json& item : list) {
    const auto x = item.get<std::array<double, 3>>();
    if (item.size() != 3) fail(file, "a vector has not three numbers; the file is damaged");
    vectors.emplace_back(x[0], x[1], x[2]);
  }
  return vectors;
}

ThinPlateSpline read_warp(const ordered_json& json, const std::string& file) {
  ThinPlateSpline warp;
  const std::string kernel = json.at("kernel");
  if (kernel != "r" && kernel != "r3") fail(file, fmt::format("the kernel '{}' is not known; use a newer homolog", homolog::shown(kernel)));
  warp.kernel = kernel == "r" ? Kernel::r : Kernel::r3;
  warp.centres = read_vectors(json.at("centres"), file);
  warp.weights = read_vectors(json.at("weights"), file);
  if (warp.centres.size() != warp.weights.size()) fail(file, "a warp has not as many weights as centres; the file is damaged");
  for (int row = 0; row < 3; ++row) {
    const auto values = json.at("affine").at(row).get<std::array<double, 4>>();
    warp.affine.row(row) = Eigen::RowVector4d(values[0], values[1], values[2], values[3]);
  }
  return warp;
}

std::vector<KnownPlace> read_known(const ordered_json& pairs, const ordered_json& points, const std::string& file) {
  std::vector<KnownPlace> known;
  for (const ordered_json& pair : pairs) {
    const auto x = points.at(pair.at("model").get<std::size_t>()).at("position").get<std::array<double, 3>>();
    const double confidence = pair.at("confidence");
    if (!(confidence >= 0 && confidence <= 1)) fail(file, "the confidence of a pair is not from 0 to 1; the file is damaged");
    known.push_back({Vec3(x[0], x[1], x[2]), confidence});
  }
  return known;
}

bool states_ras(const ordered_json& shape) { return shape.value("coordinate_system", "") == "RAS"; }

StoredFamily read_matches(const ordered_json& json, const std::string& file) {
  check_format(json, "homolog-match", file);
  const ordered_json &model = json.at("model"), &data = json.at("data");
  StoredFamily family{{model.at("file"), states_ras(model)}, {data.at("file"), states_ras(data)}, {}};
  for (const ordered_json& item : json.at("matches")) {
    MatchMap match;
    match.data_from_model = read_warp(item.at("warp"), file);
    match.known = read_known(item.at("pairs"), model.at("points"), file);
    match.scale = item.at("scale");
    for (int row = 0; row < 4; ++row) {
      const auto values = item.at("data_from_model").at(row).get<std::array<double, 4>>();
      match.similarity.row(row) = Eigen::RowVector4d(values[0], values[1], values[2], values[3]);
    }
    match.model_diagonal = model.at("diagonal");
    match.data_diagonal = data.at("diagonal");
    match.thickness = json.value("parameters", ordered_json::object()).value("thicken", 0.0);
    if (!(match.scale > 0 && match.model_diagonal > 0 && match.data_diagonal > 0))
      fail(file, "a size is not positive; the file is damaged");
    family.matches.push_back(std::move(match));
  }
  return family;
}

CoveredSamples read_samples(const ordered_json& side, const ordered_json& weights, const std::string& file) {
  CoveredSamples samples{read_vectors(side.at("samples"), file), weights.at("samples")};
  if (samples.positions.size() != samples.weights.size()) fail(file, "there are not as many weights as samples; the file is damaged");
  return samples;
}

void add_parts(const ordered_json& json, const std::string& file, StoredFamily& family) {
  check_format(json, "homolog-parts", file);
  const ordered_json &model = json.at("model"), &data = json.at("data"), &matches = json.at("matches");
  if (model.at("file") != family.model.file || data.at("file") != family.data.file || matches.size() != family.matches.size()) {
    fail(file, "it belongs to another match.json than the one beside it; run 'homolog match --out' again or take it away");
  }
  for (std::size_t i = 0; i < matches.size(); ++i) {
    family.matches[i].model = read_samples(model, matches[i].at("model"), file);
    family.matches[i].data = read_samples(data, matches[i].at("data"), file);
  }
  family.model.vertices = model.at("vertices");
  family.data.vertices = data.at("vertices");
  family.parts_known = true;
}

}  // namespace

StoredFamily read_family(const NamedText& match_json, const std::optional<NamedText>& parts_json) {
  StoredFamily family =
      read_json(match_json.text, match_json.file, "matches", [&](const ordered_json& json) { return read_matches(json, match_json.file); });
  if (parts_json) {
    read_json(parts_json->text, parts_json->file, "covered parts",
              [&](const ordered_json& json) { add_parts(json, parts_json->file, family); });
  }
  return family;
}

StoredFamily read_family(const std::filesystem::path& match_json) {
  const NamedText match{read_file(match_json), match_json.string()};
  const std::filesystem::path parts = match_json.parent_path() / "parts.json";
  if (!std::filesystem::exists(parts)) return read_family(match, std::nullopt);
  return read_family(match, NamedText{read_file(parts), parts.string()});
}

}  // namespace homolog
