// SPDX-License-Identifier: MIT
#include "homolog/match/refine.h"

#include <algorithm>
#include <limits>

#include "homolog/match/evidence.h"
#include "homolog/match/guided_pairs.h"

namespace homolog {
namespace {

constexpr ClothSchedule first_draw{16, 0.06, 0.015, 2, 0.2};
constexpr ClothSchedule next_draw{8, 0.03, 0.015, 0.7, 0.2};
constexpr int guided_rounds = 2;
constexpr std::size_t data_samples = 400;  // near the mapped part
constexpr double near_share = 0.15;        // of the mapped model's extent

std::vector<Anchor> anchors_of(const CorrespondenceSet& pairs, const Body& body) {
  std::vector<Anchor> anchors;
  for (const Correspondence& c : pairs) anchors.push_back({body.point_node(c.model), c.data_point.position});
  return anchors;
}

// The data's samples that the laid cloth can have to do with; the whole body's would draw parts apart.
std::vector<SurfaceSample> samples_near(const Cloth& cloth, const std::vector<SurfaceSample>& samples, double distance) {
  std::vector<SurfaceSample> near;
  for (const SurfaceSample& s : samples) {
    const bool is_near = std::any_of(cloth.nodes.begin(), cloth.nodes.end(),
                                     [&](const Vec3& n) { return (n - s.position).squaredNorm() < distance * distance; });
    if (is_near) near.push_back(s);
    if (near.size() == data_samples) break;
  }
  return near;
}

// The refined map as a spline through the cloth's nodes, so that any reader can apply it (Sec. 6.1).
ThinPlateSpline spline_through(const Cloth& cloth, const Body& body) {
  const std::vector<double> nugget(body.nodes.size(), 0.02 * body.spacing);
  return ThinPlateSpline::similarity_free(SourceSystem(body.nodes, nugget), cloth.nodes, cloth.chirality);
}

}  // namespace

RefinedMatch refine_set(const GrownSet& set, const Shape& model, const Shape& data, const Params& params) {
  RefinedMatch refined;
  Match& match = refined.match;
  match.pairs = set.pairs;
  Cloth& cloth = refined.cloth = lay_cloth(model.body, set.spline, set.chirality);
  const double extent = std::min(data.diagonal, cloth.scale * model.diagonal);
  const std::vector<SurfaceSample> near = samples_near(cloth, data.surface, near_share * extent);
  draw_cloth(cloth, model.body, near, extent, anchors_of(match.pairs, model.body), first_draw);
  for (int round = 0; round < guided_rounds; ++round) {
    match.pairs = guided_pairs(cloth, model, data, params.descriptor.kind);
    draw_cloth(cloth, model.body, near, extent, anchors_of(match.pairs, model.body), next_draw);
  }
  match.data_from_model = spline_through(cloth, model.body);
  match.similarity = match.data_from_model.similarity;
  match.handedness = set.chirality == Chirality::proper ? Handedness::proper : Handedness::mirrored;
  match.bending = match.data_from_model.energy / (match.similarity.scale * match.similarity.scale * model.diagonal);
  match.evidence = weigh(cloth, model.body, model.diagonal, data.surface, data.diagonal);
  match.evidence.growth_score = set.score;
  match.confidence = confidence_of(match.evidence);
  match.model_coverage = match.evidence.model_reached;
  match.data_coverage = match.evidence.data_reached;
  for (Correspondence& c : match.pairs) c.confidence *= match.confidence;
  return refined;
}

}  // namespace homolog
