// SPDX-License-Identifier: MIT
#include "found.h"

#include <nanobind/eigen/dense.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <map>

#include "arrays.h"
#include "homolog/base/parallel.h"
#include "homolog/outputs/family_files.h"
#include "homolog/outputs/match_json.h"
#include "homolog/outputs/read_match.h"
#include "homolog/outputs/symmetry_text.h"
#include "interruptible.h"
#include "results.h"

namespace nb = nanobind;

namespace homolog::python {
namespace {

using Weights = Eigen::VectorXf;
using Parameters = std::map<std::string, std::string>;

/// Without what only matching needs, which is large.
Shape as_told(const Shape& shape) {
  Shape told;
  told.name = shape.name;
  told.ras = shape.ras;
  told.diagonal = shape.diagonal;
  told.points = shape.points;
  for (const SurfaceSample& sample : shape.surface) told.surface.push_back({sample.position, Vec3::Zero()});
  return told;
}

std::vector<SurfaceSample> samples_at(const Places& places) {
  std::vector<SurfaceSample> samples;
  for (const Vec3& place : vectors_of(places)) samples.push_back({place, Vec3::Zero()});
  return samples;
}

nb::tuple fields_of(Found found, const std::vector<MatchParts>& parts, const std::vector<MatchMap>& maps) {
  const nb::tuple family = family_fields(found.family, parts, maps);
  const nb::object symmetries = found.symmetries ? nb::object(symmetries_fields(*found.symmetries)) : nb::none();
  return nb::make_tuple(family, symmetries, nb::cast(std::move(found)));
}

nb::dict shape_fields(const Shape& shape) {
  nb::dict fields;
  fields["name"] = shape.name;
  fields["ras"] = shape.ras;
  fields["diagonal"] = shape.diagonal;
  fields["points"] = points_fields(shape.points);
  return fields;
}

Parameters texts_of(const Params& params) {
  Parameters texts;
  for (const ParameterInfo& info : parameter_table()) texts[info.name] = to_text(get_parameter(params, info.name));
  return texts;
}

/// A family in a folder, both its shapes, its parameters, and whether its parts are known.
nb::tuple load(const std::filesystem::path& match_json) {
  ReadResult read;
  std::vector<MatchMap> maps;
  std::vector<MatchParts> parts;
  {
    Interruptible working;
    read = read_result(match_json);
    parts = read.parts.value_or(std::vector<MatchParts>(read.family.matches.size()));
    maps = match_maps(read.family.matches, read.model, read.data, parts);
  }
  const nb::dict model = shape_fields(read.model), data = shape_fields(read.data);
  Found found{read.params, std::move(read.model), std::move(read.data), std::move(read.family), std::move(read.symmetries)};
  return nb::make_tuple(fields_of(std::move(found), parts, maps), model, data, texts_of(read.params), read.parts.has_value());
}

/// Python holds the parts: the weights of both meshes' vertices for each match, and those of the samples in its map.
void save(const Found& found, const std::filesystem::path& folder, const Places& model_vertices, const Triangles& model_faces,
          const Places& data_vertices, const Triangles& data_faces, const std::vector<std::tuple<MatchMap*, Weights, Weights>>& matches) {
  Interruptible working;
  const ThreadLimit limit(found.params.threads);
  const Mesh model = mesh_of(model_vertices, model_faces), data = mesh_of(data_vertices, data_faces);
  std::vector<MatchParts> parts;
  const auto list_of = [](const Weights& weights) { return std::vector<float>(weights.data(), weights.data() + weights.size()); };
  for (const auto& [map, on_model, on_data] : matches) {
    parts.push_back({{list_of(on_model), map->model.weights}, {list_of(on_data), map->data.weights}});
  }
  const ToldFamily told{{model, found.model}, {data, found.data}, found.family, found.params, parts, found.symmetries};
  write_folder(folder, family_files(told));
}

// As texts of the files, and the samples of both shapes, which no file but parts.json tells.
using FoundState = std::tuple<std::string, std::optional<std::string>, Places, Places>;

FoundState state_of(const Found& found) {
  std::optional<std::string> symmetries;
  if (found.symmetries) symmetries = symmetries_json(*found.symmetries);
  return {match_json(found.model, found.data, found.family, found.params), symmetries, places_of(positions_of(found.model.surface)),
          places_of(positions_of(found.data.surface))};
}

Found found_of(const FoundState& state) {
  const auto& [matches, symmetries, on_model, on_data] = state;
  ReadResult read = read_result({matches, "pickle"}, std::nullopt);
  Found found{read.params, std::move(read.model), std::move(read.data), std::move(read.family), std::nullopt};
  if (symmetries) found.symmetries = read_symmetries(*symmetries, "pickle", found.family.matches);
  found.model.surface = samples_at(on_model);
  found.data.surface = samples_at(on_data);
  return found;
}

}  // namespace

nb::tuple family_of(const MeshedShape& model, const MeshedShape& data, Family family, const Params& params, bool against_itself) {
  std::vector<MatchParts> parts;
  std::vector<MatchMap> maps;
  Found found;
  {
    Interruptible working;
    const ThreadLimit limit(params.threads);
    parts = covered_parts(model, data, family.matches);
    maps = match_maps(family.matches, model.shape, data.shape, parts);
    for (MatchMap& map : maps) map.thickness = params.voxel.thicken;
    found = {params, as_told(model.shape), as_told(data.shape), std::move(family), std::nullopt};
    if (against_itself) found.symmetries = symmetries_of(model, found.family.matches, parts);
  }
  return fields_of(std::move(found), parts, maps);
}

void bind_found(nb::module_& module) {
  nb::class_<Found>(module, "Found", "What the files of a family tell beside what Python's own classes hold.")
      .def_prop_ro("matches", [](const Found& found) { return found.family.matches.size(); })
      .def("__getstate__", [](const Found& found) { return state_of(found); })
      .def("__setstate__", [](Found& found, const FoundState& state) { new (&found) Found(found_of(state)); });
  module.def("load", &load, nb::arg("match_json"));
  module.def("save", &save, nb::arg("found"), nb::arg("folder"), nb::arg("model_vertices"), nb::arg("model_faces"),
             nb::arg("data_vertices"), nb::arg("data_faces"), nb::arg("matches"));
}

}  // namespace homolog::python
