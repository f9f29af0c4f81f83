// SPDX-License-Identifier: MIT
#include "results.h"

#include <nanobind/eigen/dense.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "arrays.h"
#include "homolog/outputs/doubt.h"
#include "homolog/outputs/symmetry_text.h"
#include "interruptible.h"

namespace nb = nanobind;

namespace homolog::python {
namespace {

using Affine = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;
using Weights = Eigen::VectorXf;
using Pairs = Eigen::Matrix<std::int64_t, Eigen::Dynamic, 2, Eigen::RowMajor>;
using Matrix4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

Weights weights_of(const std::vector<float>& weights) {
  return values_of(weights, [](float w) { return w; });
}

nb::dict spline_fields(const ThinPlateSpline& spline) {
  nb::dict fields;
  fields["kernel"] = spline.kernel == Kernel::r ? "r" : "r3";
  fields["centres"] = places_of(spline.centres);
  fields["weights"] = places_of(spline.weights);
  fields["affine"] = Affine(spline.affine);
  return fields;
}

Pairs pairs_of(const CorrespondenceSet& set) {
  Pairs pairs(static_cast<Eigen::Index>(set.size()), 2);
  for (std::size_t i = 0; i < set.size(); ++i) pairs.row(static_cast<Eigen::Index>(i)) << set[i].model, set[i].data;
  return pairs;
}

nb::dict match_fields(const Match& match, const MatchParts& parts, const MatchMap& map) {
  nb::dict fields;
  fields["pairs"] = pairs_of(match.pairs);
  fields["pair_confidence"] = values_of(match.pairs, [](const Correspondence& c) { return c.confidence; });
  fields["model_points"] = places_of(model_positions(match.pairs));
  fields["data_points"] = places_of(data_positions(match.pairs));
  fields["data_from_model"] = spline_fields(match.data_from_model);
  fields["similarity"] = Matrix4(match.similarity.matrix());
  fields["scale"] = match.similarity.scale;
  fields["handedness"] = handedness_name(match.handedness);
  fields["confidence"] = match.confidence;
  fields["bending"] = match.bending;
  fields["chamfer"] = match.chamfer;
  fields["model_coverage"] = match.model_coverage;
  fields["data_coverage"] = match.data_coverage;
  fields["model_part"] = weights_of(parts.model.vertices);
  fields["data_part"] = weights_of(parts.data.vertices);
  fields["_map"] = map;
  return fields;
}

/// A reflection is a similarity, too.
Similarity similarity_of(const Symmetry& symmetry) {
  if (!symmetry.mirror) return symmetry.movement;
  const auto& [normal, offset] = *symmetry.mirror;
  return {1, Mat3::Identity() - 2 * normal * normal.transpose(), 2 * offset * normal};
}

nb::dict symmetry_fields(const Symmetry& symmetry) {
  nb::dict fields;
  fields["normal"] = symmetry.mirror ? nb::cast(symmetry.mirror->normal) : nb::none();
  fields["offset"] = symmetry.mirror ? nb::cast(symmetry.mirror->offset) : nb::none();
  fields["matrix"] = Matrix4(similarity_of(symmetry).matrix());
  fields["error"] = symmetry.error;
  fields["sentence"] = symmetry_sentence(symmetry);
  return fields;
}

nb::dict carry(const MatchMap& map, const Places& points, bool to_data) {
  const std::vector<Vec3> places = vectors_of(points);
  std::vector<CarriedPoint> carried;
  {
    Interruptible working;
    carried = carry_points(map, places, to_data ? Direction::data_from_model : Direction::model_from_data);
  }
  nb::dict fields;
  fields["position"] = places_of(carried, [](const CarriedPoint& p) { return p.position; });
  fields["there"] = values_of(carried, [](const CarriedPoint& p) { return p.is_there(); });
  fields["expected_error"] = values_of(carried, [](const CarriedPoint& p) { return p.expected_error; });
  fields["coverage"] = values_of(carried, [](const CarriedPoint& p) { return p.coverage.value_or(1); });
  return fields;
}

// A map as plain arrays, for pickle.
using SplineState = std::tuple<bool, Places, Places, Affine>;
using SamplesState = std::tuple<Places, Weights, Places>;
using KnownState = std::pair<Places, std::vector<double>>;
using MapState = std::tuple<SplineState, KnownState, double, Mat4, double, double, double, double, SamplesState, SamplesState>;

SplineState state_of(const ThinPlateSpline& spline) {
  return {spline.kernel == Kernel::r3, places_of(spline.centres), places_of(spline.weights), spline.affine};
}
SamplesState state_of(const CoveredSamples& samples) {
  const auto& box = samples.box;
  return {places_of(samples.positions), weights_of(samples.weights),
          places_of(box ? std::vector{box->min, box->max} : std::vector<Vec3>{})};
}
KnownState state_of(const std::vector<KnownPlace>& known) {
  std::vector<double> confidences;
  for (const KnownPlace& place : known) confidences.push_back(place.confidence);
  return {places_of(known, [](const KnownPlace& place) { return place.position; }), confidences};
}
MapState state_of(const MatchMap& map) {
  return {state_of(map.data_from_model),
          state_of(map.known),
          map.scale,
          map.similarity,
          map.model_diagonal,
          map.data_diagonal,
          map.thickness,
          map.confidence,
          state_of(map.model),
          state_of(map.data)};
}

ThinPlateSpline spline_of(const SplineState& state) {
  ThinPlateSpline spline;
  spline.kernel = std::get<0>(state) ? Kernel::r3 : Kernel::r;
  spline.centres = vectors_of(std::get<1>(state));
  spline.weights = vectors_of(std::get<2>(state));
  spline.affine = std::get<3>(state);
  return spline;
}
CoveredSamples samples_of(const SamplesState& state) {
  const auto& [positions, weights, box] = state;
  const std::vector<Vec3> ends = vectors_of(box);
  return {vectors_of(positions),
          {weights.data(), weights.data() + weights.size()},
          ends.empty() ? std::nullopt : std::optional(Box{ends.at(0), ends.at(1)})};
}
std::vector<KnownPlace> known_of(const KnownState& state) {
  std::vector<KnownPlace> known;
  for (const Vec3& position : vectors_of(state.first)) known.push_back({position, state.second.at(known.size())});
  return known;
}
MatchMap map_of(const MapState& state) {
  const auto& [spline, known, scale, similarity, model_diagonal, data_diagonal, thickness, confidence, model, data] = state;
  return {spline_of(spline), known_of(known), scale,      similarity,        model_diagonal,
          data_diagonal,     thickness,       confidence, samples_of(model), samples_of(data)};
}

}  // namespace

nb::dict points_fields(const std::vector<SalientPoint>& points) {
  const auto direction = [](const SalientPoint& p) -> Vec3 { return p.direction_length > 0 ? p.direction : Vec3::Constant(NAN); };
  nb::dict fields;
  fields["position"] = places_of(points, [](const SalientPoint& p) { return p.position; });
  fields["radius"] = values_of(points, [](const SalientPoint& p) { return p.radius; });
  fields["direction"] = places_of(points, direction);
  fields["response"] = values_of(points, [](const SalientPoint& p) { return p.response; });
  return fields;
}

nb::tuple family_fields(const Family& family, const std::vector<MatchParts>& parts, const std::vector<MatchMap>& maps) {
  nb::list matches;
  for (std::size_t i = 0; i < family.matches.size(); ++i) matches.append(match_fields(family.matches[i], parts[i], maps[i]));
  nb::dict counts;
  for (const auto& [stage, count] : family.counts.stages) counts[stage.c_str()] = count;
  return nb::make_tuple(matches, counts, points_fields(family.followed), doubt_sentence(family));
}

nb::list symmetries_fields(const std::vector<Symmetry>& symmetries) {
  nb::list list;
  for (const Symmetry& symmetry : symmetries) list.append(symmetry_fields(symmetry));
  return list;
}

nb::class_<MatchMap> bind_match_map(nb::module_& module) {
  return nb::class_<MatchMap>(module, "MatchMap", "What carrying points by a match needs.")
      .def("carry", &carry, nb::arg("points"), nb::arg("to_data"))
      .def("__getstate__", [](const MatchMap& map) { return state_of(map); })
      .def("__setstate__", [](MatchMap& map, const MapState& state) { new (&map) MatchMap(map_of(state)); });
}

}  // namespace homolog::python
