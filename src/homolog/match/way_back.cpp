// SPDX-License-Identifier: MIT
#include "homolog/match/way_back.h"

#include <algorithm>
#include <cmath>

#include "homolog/match/best_similarity.h"
#include "homolog/match/draw_onto.h"
#include "homolog/match/laid_limbs.h"

namespace homolog {
namespace {

constexpr int steps = 8;                    // of either draw
constexpr std::size_t model_samples = 400;  // near the mapped part
constexpr double farthest = 1;              // extents; beyond, a map tells nothing
constexpr std::size_t asked = 6;            // nodes

// Each near node carries x along in its frame; the nearest count most.
template <typename Frame>
Vec3 carried(const NearestPoints& near, const std::vector<Vec3>& from, const std::vector<Vec3>& to, const Frame& frame, const Vec3& x) {
  Vec3 sum = Vec3::Zero();
  double weights = 0;
  for (const auto& [square, node] : near.nearest(x, asked)) {
    if (square == 0) return to[node];
    const double weight = 1 / square;
    sum += weight * (to[node] + frame(node) * (x - from[node]));
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

Cloth laid_back(const Cloth& cloth, const Shape& model, const Shape& data) {
  const auto frame = [&](std::size_t i) -> Mat3 { return cloth.rotations[i].transpose() / cloth.scales[i]; };
  const NearestPoints near(cloth.nodes);
  std::vector<Vec3> places;
  for (const Vec3& node : data.body.nodes) places.push_back(carried(near, cloth.nodes, model.body.nodes, frame, node));
  std::vector<WeighedPair> pairs;
  for (std::size_t i = 0; i < model.body.surface_count; ++i) pairs.push_back({cloth.nodes[i], model.body.nodes[i], 1});
  Cloth back = lay_cloth(data.body, std::move(places), best_similarity(pairs, cloth.chirality), cloth.chirality);
  draw_onto(back, data, model, {}, first_draw(steps), model_samples);
  draw_onto(back, data, model, lay_limbs_of_other_length(back, data, model), last_draw(steps), model_samples);
  return back;
}

Vec3 place_in(const Cloth& cloth, const Body& body, const NearestPoints& near, const Vec3& x) {
  return carried(
      near, body.nodes, cloth.nodes, [&](std::size_t i) -> const Mat3& { return cloth.frames[i]; }, x);
}

void rate_by_way_back(CorrespondenceSet& pairs, const Cloth& back, const Body& data, double extent) {
  const NearestPoints near(data.nodes);
  for (Correspondence& c : pairs) {
    const double missed = (place_in(back, data, near, c.data_point.position) - c.model_point.position).norm() / extent;
    const double odds_against = (1 - c.confidence) / std::max(c.confidence, 1e-9);
    c.confidence = 1 / (1 + odds_against * std::exp(1.18) * std::pow(0.01 + std::min(missed, farthest), 0.54));
  }
}

}  // namespace homolog
