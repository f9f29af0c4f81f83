// SPDX-License-Identifier: MIT
#include "homolog/match/evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace homolog {
namespace {

constexpr double reach_share = 0.02;  // of the mapped model's diagonal: so near counts as reached
constexpr double near_share = 0.1;    // so near, data counts as the part the model should explain

struct Nearest {
  double plane_distance = std::numeric_limits<double>::infinity(), distance = plane_distance;
  bool agrees = false;  // normals within 60 degrees
};

Nearest nearest(const Vec3& place, const Vec3& normal, const std::vector<Vec3>& places, const std::vector<Vec3>& normals) {
  Nearest result;
  std::size_t best = 0;
  double square = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double d = (places[k] - place).squaredNorm();
    if (d < square) {
      square = d;
      best = k;
    }
  }
  if (places.empty()) return result;
  result.distance = std::sqrt(square);
  result.plane_distance = std::abs((places[best] - place).dot(normals[best]));
  result.agrees = normal.dot(normals[best]) > 0.5;
  return result;
}

double typical_spacing(const std::vector<Vec3>& places) {
  std::vector<double> distances;
  for (const Vec3& p : places) {
    double square = std::numeric_limits<double>::infinity();
    for (const Vec3& q : places) {
      const double d = (p - q).squaredNorm();
      if (d > 0) square = std::min(square, d);
    }
    distances.push_back(std::sqrt(square));
  }
  if (distances.empty()) return 0;
  std::nth_element(distances.begin(), distances.begin() + distances.size() / 2, distances.end());
  return distances[distances.size() / 2];
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

Evidence weigh(const Cloth& cloth, const Body& model, double model_diagonal, const std::vector<SurfaceSample>& data, double data_diagonal) {
  const double extent = std::min(data_diagonal, cloth.scale * model_diagonal), reach = reach_share * extent;
  std::vector<Vec3> skin, skin_normals, places, normals;
  for (std::size_t i = 0; i < model.surface_count; ++i) {
    skin.push_back(cloth.nodes[i]);
    skin_normals.push_back(cloth.rotations[i] * model.normals[i]);
  }
  for (const SurfaceSample& s : data) {
    places.push_back(s.position);
    normals.push_back(s.normal);
  }
  const double data_spacing = typical_spacing(places), skin_spacing = typical_spacing(skin);
  Evidence evidence;
  double model_hits = 0, near = 0, data_hits = 0;
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const Nearest n = nearest(skin[i], skin_normals[i], places, normals);
    if (n.agrees && n.plane_distance < reach && n.distance < reach + data_spacing) ++model_hits;
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Nearest n = nearest(places[k], normals[k], skin, skin_normals);
    if (n.distance < near_share * extent) ++near;
    if (n.agrees && n.plane_distance < reach && n.distance < reach + skin_spacing) ++data_hits;
  }
  if (!skin.empty()) evidence.model_reached = model_hits / static_cast<double>(skin.size());
  if (!places.empty()) evidence.data_reached = data_hits / static_cast<double>(places.size());
  if (near > 0) evidence.data_near_reached = data_hits / near;
  evidence.stretch = edge_stretch(cloth, model);
  return evidence;
}

double merit_of(const Evidence& evidence) {
  const double both = std::sqrt(evidence.model_reached * evidence.data_near_reached);
  return 1.5 * both - evidence.stretch + 0.015 * evidence.growth_score;
}

double confidence_of(const Evidence& evidence) { return 1 / (1 + std::exp(13.7 - 12.5 * merit_of(evidence))); }

}  // namespace homolog
