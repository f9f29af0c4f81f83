// SPDX-License-Identifier: MIT
#include "homolog/match/evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "homolog/match/bending_invariants.h"
#include "homolog/match/contact.h"

namespace homolog {
namespace {

constexpr double near_share = 0.1;        // so near along the inside, data counts as the part the model should explain
constexpr double enough_merit = 0.8;      // a smooth shape has more, be it laid rightly or not
constexpr double mirror_handicap = 0.11;  // merit by which a mirrored match must be better to come first

// Within a flat face, as a cut leaves one?
bool in_flat_face(const Body& body, int node) {
  int flat = 0;
  for (const int other : body.neighbours[node]) {
    if (!neighbours_on_skin(body, node, other)) continue;
    if (body.normals[other].dot(body.normals[node]) < 0.96) return false;  // 16 degrees
    ++flat;
  }
  return flat >= 3;
}

// Share of the model's skin that comes to lie on the data's. Flat faces that end inside the data do not count: where the model was cut
// off, the data goes on.
double model_reached(const std::vector<SurfaceSample>& laid, const std::vector<NearestSample>& nearest, const Skin& data_skin,
                     const Body& model, const Interior& data, double reach) {
  double reached = 0, cut = 0;
  for (std::size_t i = 0; i < laid.size(); ++i) {
    if (reaches(laid[i], nearest[i], data_skin, reach)) {
      ++reached;
    } else if (in_flat_face(model, static_cast<int>(i)) && sample(data, laid[i].position) > 0.9f) {
      ++cut;
    }
  }
  const double counted = static_cast<double>(laid.size()) - cut;
  return counted > 0 ? reached / counted : 0;
}

// Share that is reached of the data's skin that lies near along the inside: an arm that hangs beside a torso is far from it.
double near_reached(const Skin& laid, const Shape& data, double reach, double near) {
  const auto skin = static_cast<Eigen::Index>(data.body.surface_count);
  Eigen::ArrayXd ways = Eigen::ArrayXd::Constant(skin, std::numeric_limits<double>::infinity());
  double reached = 0;
  for (Eigen::Index k = 0; k < skin; ++k) {
    if (reaches(data.surface[k], laid, reach)) ways = ways.min(data.body.ways.col(k).head(skin).array()), ++reached;
  }
  const auto count = (ways < near).count();
  return count > 0 ? reached / static_cast<double>(count) : 0;
}

// What lies within `farthest` of each place.
std::vector<NearestSample> nearest_to(const std::vector<SurfaceSample>& laid, const Skin& skin, double farthest) {
  std::vector<NearestSample> nearest;
  for (const SurfaceSample& sample : laid) nearest.push_back(nearest_sample(skin.blocks, sample.position, farthest));
  return nearest;
}

// Between the rotations of a node and of a neighbour, in radians.
double turning_between(const Cloth& cloth, int a, int b) {
  return std::acos(std::clamp(((cloth.rotations[a].transpose() * cloth.rotations[b]).trace() - 1) / 2, -1.0, 1.0));
}

// A joint bends a few nodes much, a wrong map all of them a little.
double mean_turning(const Cloth& cloth, const Body& model) {
  double sum = 0, count = 0;
  for (int i = 0; i < static_cast<int>(model.nodes.size()); ++i) {
    for (const int j : model.neighbours[i]) sum += turning_between(cloth, i, j), ++count;
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace

double extent_of(const Cloth& cloth, const Shape& model, const Shape& data) {
  return matched_extent(model.diagonal, cloth.scale, data.diagonal);
}

double turning_at(const Cloth& cloth, const Body& model, int node) {
  double sum = 0;
  for (const int neighbour : model.neighbours[node]) sum += turning_between(cloth, node, neighbour);
  return sum / std::max(1.0, static_cast<double>(model.neighbours[node].size()));
}

Evidence weigh(const Cloth& cloth, const Shape& model, const Shape& data) {
  const double extent = extent_of(cloth, model, data), reach = reached_share * extent;
  if (model.body.surface_count == 0 || data.surface.empty()) return {};
  const LaidSkin skin = laid_skin(mapped_skin(cloth, model.body), model.body.skin_order);
  const std::vector<SurfaceSample>& laid = skin.samples;
  const Skin data_skin{data.surface, data.surface_blocks, data.surface_spacing};
  const auto nearest = nearest_to(laid, data_skin, std::max(reach + data_skin.spacing, skin_near * extent));
  Evidence evidence;
  evidence.model_reached = model_reached(laid, nearest, data_skin, model.body, data.interior, reach);
  evidence.data_near_reached = near_reached(skin.view(), data, reach, near_share * extent);
  evidence.turning = mean_turning(cloth, model.body);
  evidence.ways_changed = ways_changed(laid, cloth.scale, model, data, extent);
  evidence.thickness_changed = thickness_changed(laid, nearest, model, data, extent);
  evidence.ends_missed = ends_missed(cloth, model, data, extent);
  return evidence;
}

double model_reached(const Cloth& cloth, const Shape& model, const Shape& data) {
  if (model.body.surface_count == 0 || data.surface.empty()) return 0;
  const double reach = reached_share * extent_of(cloth, model, data);
  const std::vector<SurfaceSample> laid = mapped_skin(cloth, model.body);
  const Skin data_skin{data.surface, data.surface_blocks, data.surface_spacing};
  return model_reached(laid, nearest_to(laid, data_skin, reach + data_skin.spacing), data_skin, model.body, data.interior, reach);
}

double data_reached(const Cloth& cloth, const Shape& model, const Shape& data) {
  if (model.body.surface_count == 0 || data.surface.empty()) return 0;
  const LaidSkin skin = laid_skin(mapped_skin(cloth, model.body), model.body.skin_order);
  const double reach = reached_share * extent_of(cloth, model, data);
  const auto reached =
      std::count_if(data.surface.begin(), data.surface.end(), [&](const auto& s) { return reaches(s, skin.view(), reach); });
  return static_cast<double>(reached) / static_cast<double>(data.surface.size());
}

double merit_of(const Evidence& evidence) {
  const double both = std::sqrt(evidence.model_reached * evidence.data_near_reached);
  const double changed = 1.3 * evidence.ways_changed + evidence.thickness_changed + 1.95 * evidence.ends_missed;
  return 1.4 * both - 2.2 * evidence.turning + 0.022 * evidence.support - changed;
}

double rank_merit(const Evidence& evidence, Chirality chirality) {
  return merit_of(evidence) - (chirality == Chirality::mirrored ? mirror_handicap : 0);
}

double confidence_of(const Evidence& evidence, Chirality chirality, double ways) {
  const double merit = rank_merit(evidence, chirality), beyond = std::max(0.0, merit - enough_merit);
  return 1 / (1 + std::exp(0.07 - 5.8 * (merit - 0.9 * beyond) + 1.6 * std::log(ways)));
}

}  // namespace homolog
