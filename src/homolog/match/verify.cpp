// SPDX-License-Identifier: MIT
#include "homolog/match/verify.h"

#include <algorithm>
#include <cmath>

#include "homolog/base/parallel.h"
#include "homolog/match/chamfer.h"
#include "homolog/match/clique_growth.h"
#include "homolog/match/family.h"

namespace homolog {
namespace {

constexpr int lattice_cells = 32;    // along the model's longest side
constexpr double covered_radii = 4;  // as far as the paper's descriptors look

// Share of a skin that lies as near to the matched points as their descriptors look.
double covered_share(const std::vector<SurfaceSample>& skin, const std::vector<SalientPoint>& points) {
  if (skin.empty()) return 0;
  std::vector<InteriorSample> samples;
  for (const SurfaceSample& sample : skin) samples.push_back({sample.position, 1});
  return static_cast<double>(covered_samples(samples, points, covered_radii).size()) / static_cast<double>(samples.size());
}

std::vector<SalientPoint> points_of(const CorrespondenceSet& set, SalientPoint Correspondence::*side) {
  std::vector<SalientPoint> points;
  for (const Correspondence& c : set) points.push_back(c.*side);
  return points;
}

Match match_of(const CorrespondenceSet& set, const Shape& model, const Shape& data) {
  const std::vector<Vec3> sources = model_positions(set), targets = data_positions(set);
  Match match;
  match.pairs = set;
  match.data_from_model = ThinPlateSpline::affine_free(sources, targets);
  match.bending = affine_free_bending(set, model.diagonal);
  const bool mirrored = match.data_from_model.affine.leftCols<3>().determinant() < 0;
  const SourceSystem system(sources, std::vector<double>(sources.size(), 0));
  const Chirality chirality = mirrored ? Chirality::mirrored : Chirality::proper;
  match.similarity = ThinPlateSpline::similarity_free(system, targets, chirality).similarity;
  match.handedness = mirrored ? Handedness::mirrored : Handedness::proper;
  match.confidence = static_cast<double>(set.size()) / static_cast<double>(model.points.size());
  for (Correspondence& c : match.pairs) c.confidence = match.confidence;
  match.model_coverage = covered_share(model.surface, points_of(set, &Correspondence::model_point));
  match.data_coverage = covered_share(data.surface, points_of(set, &Correspondence::data_point));
  return match;
}

bool is_identity(const CorrespondenceSet& set) {
  return std::all_of(set.begin(), set.end(), [](const Correspondence& c) { return c.model == c.data; });
}

bool wanted(const Match& match, const Params& params) {
  if (!(match.bending < params.paper.bending_limit)) return false;  // eq. 8
  return allowed(match.handedness == Handedness::mirrored ? Chirality::mirrored : Chirality::proper, params.match.mirror);
}

}  // namespace

void measure_chamfer(std::vector<Match>& matches, const Shape& model, const Shape& data) {
  if (matches.empty()) return;
  const std::vector<InteriorSample> samples = sample_interior(model.interior, lattice_cells);
  const InsideTree inside(data.interior);
  parallel_for(matches.size(), [&](std::size_t m) {
    const auto covered = covered_samples(samples, points_of(matches[m].pairs, &Correspondence::model_point), covered_radii);
    matches[m].chamfer = chamfer_distance(covered, matches[m].data_from_model, inside, data.diagonal);
  });
}

std::vector<Match> verified_sets(const std::vector<CorrespondenceSet>& sets, const Shape& model, const Shape& data, const Params& params,
                                 bool without_identity) {
  std::vector<Match> matches;
  for (const CorrespondenceSet& set : sets) {
    if (without_identity && is_identity(set)) continue;
    Match match = match_of(set, model, data);
    if (wanted(match, params)) matches.push_back(std::move(match));
  }
  measure_chamfer(matches, model, data);
  std::erase_if(matches, [&](const Match& match) { return !(match.chamfer < params.paper.chamfer_limit); });  // eq. 9
  std::stable_sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) { return a.pairs.size() > b.pairs.size(); });
  if (static_cast<int>(matches.size()) > params.match.matches) matches.resize(params.match.matches);
  return matches;
}

}  // namespace homolog
