// SPDX-License-Identifier: MIT
#include "homolog/match/way_back.h"

#include <algorithm>
#include <cmath>

#include "homolog/match/draw_onto.h"

namespace homolog {
namespace {

constexpr ClothSchedule first_draw{8, 0.06, 0.015, 2, 0.2};
constexpr ClothSchedule last_draw{8, 0.03, 0.008, 0.7, 0.1};
constexpr std::size_t model_samples = 400;  // near the mapped part
constexpr double farthest = 1;              // extents; beyond, a spline tells nothing

}  // namespace

ThinPlateSpline way_back(const Cloth& cloth, const Shape& model, const Shape& data) {
  const std::vector<double> nugget(cloth.nodes.size(), 0.02 * model.body.spacing * cloth.scale);
  const SourceSystem laid(cloth.nodes, nugget);
  const ThinPlateSpline inverse = ThinPlateSpline::similarity_free(laid, model.body.nodes, cloth.chirality);
  Cloth back = lay_cloth(data.body, inverse, cloth.chirality);
  for (const ClothSchedule& schedule : {first_draw, last_draw}) draw_onto(back, data, model, {}, schedule, model_samples);
  return spline_through(back, data.body);
}

void rate_by_way_back(CorrespondenceSet& pairs, const ThinPlateSpline& model_from_data, double extent) {
  for (Correspondence& c : pairs) {
    const double missed = (model_from_data(c.data_point.position) - c.model_point.position).norm() / extent;
    const double odds_against = (1 - c.confidence) / std::max(c.confidence, 1e-9);
    c.confidence = 1 / (1 + odds_against * std::exp(1.68) * std::pow(0.01 + std::min(missed, farthest), 0.54));
  }
}

}  // namespace homolog
