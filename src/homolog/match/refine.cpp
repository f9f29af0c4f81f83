// SPDX-License-Identifier: MIT
#include "homolog/match/refine.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "homolog/match/draw_onto.h"
#include "homolog/match/evidence.h"
#include "homolog/match/followed_points.h"
#include "homolog/match/guided_pairs.h"
#include "homolog/match/laid_limbs.h"
#include "homolog/match/limbs.h"
#include "homolog/match/regions.h"
#include "homolog/match/rigid_draw.h"
#include "homolog/match/trusted_pairs.h"
#include "homolog/match/turned_limbs.h"
#include "homolog/match/way_back.h"

namespace homolog {
namespace {

constexpr int last_steps = 14;
constexpr ClothSchedule outward_step{1, 0.05, 0.05, 0.3, 0.3};
constexpr int outward_steps = 10;
constexpr double first_front = 0.45, last_front = 1.05;  // of the longest way from the node; at an end, first the region that was laid
constexpr ClothSchedule next_draw{8, 0.03, 0.015, 0.7, 0.2};
constexpr ClothSchedule limb_draw{10, 0.08, 0.02, 0.7, 0.2};
constexpr ClothSchedule unstretched_draw{14, 0.03, 0.03, 2.8, 2.8, 0};
constexpr std::size_t data_samples = 400, last_data_samples = 1200;  // near the mapped part
constexpr PairLimits wide{1.5, 0.55};                                // while the map is still rough
constexpr double worth_lengthening = 0.06;                           // merit
constexpr double reach_given_up = 0.10;                              // of the model's skin, for not bending
constexpr double told_place = 0.05;                                  // extents: the least limit of pairs told in the end

// The refined map as a spline through the cloth's nodes, so that any reader can apply it (Sec. 6.1).
ThinPlateSpline spline_through(const Cloth& cloth, const Body& body) {
  const std::vector<double> nugget(body.nodes.size(), 0.02 * body.spacing);
  return ThinPlateSpline::similarity_free(SourceSystem(body.nodes, nugget), cloth.nodes, cloth.chirality);
}

// Delta of the spline through the pairs alone, free of unit: what the paper calls bending (eq. 8).
double bending_of(const CorrespondenceSet& pairs, Chirality chirality, double model_diagonal) {
  if (pairs.size() < 2) return 0;
  const SourceSystem system(model_positions(pairs), std::vector<double>(pairs.size(), 0));
  const ThinPlateSpline spline = ThinPlateSpline::similarity_free(system, data_positions(pairs), chirality);
  return spline.energy / (spline.similarity.scale * spline.similarity.scale * model_diagonal);
}

// What bends at a joint is brought on to the data by what lies before the joint. At each step it may come near other samples.
void draw_outwards(Cloth& cloth, std::size_t node, const Shape& model, const Shape& data) {
  const double first = first_front * longest_way_from(model.body, node), growth = last_front / first_front;
  ClothSchedule schedule = outward_step;
  for (int step = 0; step < outward_steps; ++step) {
    schedule.front = Front{node, first * std::pow(growth, static_cast<double>(step) / (outward_steps - 1))};
    draw_onto(cloth, model, data, {}, schedule, data_samples);
  }
}

void weigh_again(Refined& refined, const Shape& model, const Shape& data, DescriptorKind kind) {
  refined.evidence = weigh(refined.cloth, model, data);
  for (const Correspondence& c : guided_pairs(refined.cloth, model, data, kind, {})) refined.evidence.support += c.confidence;
}

// The last draw, with the pairs that the cloth explains.
void settle(Refined& refined, const Shape& model, const Shape& data, DescriptorKind kind) {
  refined.pairs = guided_pairs(refined.cloth, model, data, kind, {});
  draw_onto(refined.cloth, model, data, anchors_of(refined.pairs, model.body), last_draw(last_steps), last_data_samples);
  weigh_again(refined, model, data, kind);
}

// How well a cloth lies, of several for the same match.
double fit_of(const Refined& refined, const Shape& model, const Shape& data) {
  const Evidence& evidence = refined.evidence;
  return evidence.model_reached + data_reached(refined.cloth, model, data) - evidence.thickness_changed - evidence.ends_missed;
}

// A part of a body as it is does not bend: laid by one similarity it may lie better. What bends would gain in merit by not bending, too,
// but it would lose reach.
void try_rigid(Refined& refined, const Shape& model, const Shape& data, DescriptorKind kind) {
  Refined rigid = refined;
  rigid.cloth = rigidly_drawn(refined.cloth, model, data);
  if (model_reached(rigid.cloth, model, data) < refined.evidence.model_reached - reach_given_up) return;
  weigh_again(rigid, model, data, kind);
  if (merit_of(rigid.evidence) > merit_of(refined.evidence)) refined = std::move(rigid);
}

// Of the cloth as it is, drawn along the limbs, and with turned limbs laid anew before, the one that fits best stays.
void settle_with_limbs(Refined& refined, const Shape& model, const Shape& data, DescriptorKind kind) {
  const EndsTogether near = ends_together(refined.cloth, model, data);
  Refined along = refined, anew = refined;
  const auto try_along = [&](Refined& other, const EndsTogether& ends) {
    draw_onto(other.cloth, model, data, {}, limb_draw, data_samples, ends);
    settle(other, model, data, kind);
    if (fit_of(other, model, data) > fit_of(refined, model, data)) refined = std::move(other);
  };
  settle(refined, model, data, kind);
  if (near.model.empty()) return;
  try_along(along, near);
  const EndsTogether turned = turned_ends(near, anew.cloth, model, data);
  if (turned.model.empty()) return;
  const EndsTogether all = joined(near, turned);
  std::vector<std::size_t> added(turned.model.size());
  std::iota(added.begin(), added.end(), near.model.size());
  lay_limbs(anew.cloth, all, added, model, data);
  anew.cloth.rest = refined.cloth.rest;  // cloths are compared that keep their proportions
  try_along(anew, all);
}

// All that the cloth explains.
void pair_up(Refined& refined, const Shape& model, const Shape& data, DescriptorKind kind) {
  const double extent = extent_of(refined.cloth, model, data);
  refined.pairs = guided_pairs(refined.cloth, model, data, kind, {0.6, 0.5, told_place * extent});
  rate_pairs(refined.pairs, refined.cloth, merit_of(refined.evidence), extent, model, data, kind);
}

// What the data has beyond the border of a part draws that border on, and nothing draws it back: drawn again as if its edges could not
// stretch, and by the last draw, the cloth may lie better.
void release_stretch(Refined& refined, const Shape& model, const Shape& data, DescriptorKind kind) {
  Refined released = refined;
  draw_onto(released.cloth, model, data, anchors_of(released.pairs, model.body), unstretched_draw, data_samples);
  settle(released, model, data, kind);
  if (merit_of(released.evidence) >= merit_of(refined.evidence)) refined = std::move(released);
}

// Limbs whose ends fell short or went too far are laid at full length, unless that makes the whole lie much worse: where a part is cut off
// it has corners that look like ends.
void lengthen_limbs(Refined& refined, const Shape& model, const Shape& data, DescriptorKind kind) {
  Refined lengthened = refined;
  const std::vector<Anchor> tips = lay_limbs_of_other_length(lengthened.cloth, model, data);
  if (tips.empty()) return;
  draw_onto(lengthened.cloth, model, data, tips, last_draw(last_steps), last_data_samples);
  weigh_again(lengthened, model, data, kind);
  if (merit_of(lengthened.evidence) >= merit_of(refined.evidence) - worth_lengthening) refined = std::move(lengthened);
}

}  // namespace

Refined lay_set(const GrownSet& set, const Shape& model, const Shape& data) {
  Refined laid{set.pairs, lay_cloth(model.body, set.spline, set.chirality), {}, 0};
  if (set.drawn_from) draw_outwards(laid.cloth, *set.drawn_from, model, data);
  return laid;
}

void draw_set(Refined& refined, const Shape& model, const Shape& data, DescriptorKind kind, int begin, int end) {
  draw_onto(refined.cloth, model, data, anchors_of(refined.pairs, model.body), steps_of(first_draw(first_steps), begin, end), data_samples);
  weigh_again(refined, model, data, kind);
}

void guide_pairs(Refined& refined, const Shape& model, const Shape& data, DescriptorKind kind) {
  for (int round = 0; round < 2; ++round) {
    refined.pairs = guided_pairs(refined.cloth, model, data, kind, wide);
    draw_onto(refined.cloth, model, data, anchors_of(refined.pairs, model.body), next_draw, data_samples);
  }
  settle_with_limbs(refined, model, data, kind);
  try_rigid(refined, model, data, kind);
  pair_up(refined, model, data, kind);
}

void finish(Refined& refined, const Shape& model, const Shape& data, DescriptorKind kind) {
  Refined laid = refined;
  release_stretch(laid, model, data, kind);
  lengthen_limbs(laid, model, data, kind);
  try_rigid(laid, model, data, kind);
  refined.cloth = std::move(laid.cloth);
  pair_up(refined, model, data, kind);
}

Match match_of(const Refined& refined, const Shape& model, const Shape& data, const Params& params) {
  Match match;
  const double extent = extent_of(refined.cloth, model, data);
  CorrespondenceSet rated = refined.pairs;
  CorrespondenceSet followed = followed_pairs(rated, refined.cloth, merit_of(refined.evidence), extent, model, data);
  const Cloth back = laid_back(refined.cloth, model, data);
  for (CorrespondenceSet* pairs : {&rated, &followed}) rate_by_way_back(*pairs, back, data.body, extent / refined.cloth.scale);
  match.pairs = told_pairs(std::move(rated), followed);
  describe_followed(match.pairs, model, data, params);
  match.data_from_model = spline_through(refined.cloth, model.body);
  match.similarity = similarity_of(refined.cloth, model.body);
  match.handedness = refined.cloth.chirality == Chirality::proper ? Handedness::proper : Handedness::mirrored;
  match.bending = bending_of(match.pairs, refined.cloth.chirality, model.diagonal);
  match.evidence = refined.evidence;
  match.confidence = refined.confidence;
  match.model_coverage = model_reached(refined.cloth, model, data);
  match.data_coverage = data_reached(refined.cloth, model, data);
  return match;
}

}  // namespace homolog
