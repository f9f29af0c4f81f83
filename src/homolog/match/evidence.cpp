// SPDX-License-Identifier: MIT
#include "homolog/match/evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "homolog/match/sample_blocks.h"

namespace homolog {
namespace {

constexpr double reach_share = 0.02;      // of the mapped model's diagonal: so near counts as reached
constexpr double near_share = 0.1;        // so near, data counts as the part the model should explain
constexpr double mirror_handicap = 0.15;  // merit by which a mirrored match must be better to come first

struct Nearest {
  double plane_distance = std::numeric_limits<double>::infinity(), distance = plane_distance;
  bool agrees = false;  // normals within 60 degrees
};

struct Skin {
  std::vector<Vec3> places, normals;
  double spacing;
  SampleBlocks blocks;
};

Nearest nearest(const Vec3& place, const Vec3& normal, const Skin& skin) {
  const NearestSample found = nearest_sample(skin.blocks, place);
  if (found.sample < 0) return {};
  const Vec3 &there = skin.places[found.sample], &facing = skin.normals[found.sample];
  return {std::abs((there - place).dot(facing)), found.distance, normal.dot(facing) > 0.5};
}

Skin mapped_skin(const Cloth& cloth, const Body& model) {
  Skin skin;
  for (std::size_t i = 0; i < model.surface_count; ++i) {
    skin.places.push_back(cloth.nodes[i]);
    skin.normals.emplace_back(cloth.rotations[i] * model.normals[i]);
  }
  skin.spacing = typical_spacing(skin.places);
  skin.blocks = make_blocks(skin.places, skin.normals);
  return skin;
}

Skin skin_of(const Shape& data) {
  Skin skin{positions_of(data.surface), {}, data.surface_spacing, {}};
  for (const SurfaceSample& s : data.surface) skin.normals.push_back(s.normal);
  skin.blocks = make_blocks(skin.places, skin.normals);
  return skin;
}

double edge_stretch(const Cloth& cloth, const Body& model) {
  std::vector<double> logs;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    for (int j : model.neighbours[i]) {
      const double before = (model.nodes[i] - model.nodes[j]).norm() * cloth.scale, after = (cloth.nodes[i] - cloth.nodes[j]).norm();
      if (static_cast<int>(i) < j && before > 0) logs.push_back(std::log(std::max(after, 1e-3 * before) / before));
    }
  }
  if (logs.empty()) return 0;
  std::sort(logs.begin(), logs.end());
  return logs[logs.size() * 85 / 100] - logs[logs.size() * 15 / 100];
}

}  // namespace

Evidence weigh(const Cloth& cloth, const Shape& model, const Shape& data) {
  const double extent = std::min(data.diagonal, cloth.scale * model.diagonal), reach = reach_share * extent;
  const Skin cloth_skin = mapped_skin(cloth, model.body), data_skin = skin_of(data);
  Evidence evidence;
  double model_hits = 0, near = 0, data_hits = 0;
  const auto hits = [&](const Nearest& n, const Skin& other) {
    return n.agrees && n.plane_distance < reach && n.distance < reach + other.spacing;
  };
  for (std::size_t i = 0; i < cloth_skin.places.size(); ++i) {
    if (hits(nearest(cloth_skin.places[i], cloth_skin.normals[i], data_skin), data_skin)) ++model_hits;
  }
  for (std::size_t k = 0; k < data_skin.places.size(); ++k) {
    const Nearest n = nearest(data_skin.places[k], data_skin.normals[k], cloth_skin);
    if (n.distance < near_share * extent) ++near;
    if (hits(n, cloth_skin)) ++data_hits;
  }
  if (!cloth_skin.places.empty()) evidence.model_reached = model_hits / static_cast<double>(cloth_skin.places.size());
  if (!data_skin.places.empty()) evidence.data_reached = data_hits / static_cast<double>(data_skin.places.size());
  if (near > 0) evidence.data_near_reached = data_hits / near;
  evidence.stretch = edge_stretch(cloth, model.body);
  return evidence;
}

double merit_of(const Evidence& evidence) {
  const double both = std::sqrt(evidence.model_reached * evidence.data_near_reached);
  return 2.2 * both - evidence.stretch + 0.047 * evidence.support;
}

double rank_merit(const Evidence& evidence, Chirality chirality) {
  return merit_of(evidence) - (chirality == Chirality::mirrored ? mirror_handicap : 0);
}

double confidence_of(const Evidence& evidence, Chirality chirality) {
  return 1 / (1 + std::exp(10.7 - 5.65 * rank_merit(evidence, chirality)));
}

}  // namespace homolog
