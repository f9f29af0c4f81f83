// SPDX-License-Identifier: MIT
#include "homolog/match/carry_attributes.h"

#include <algorithm>
#include <cmath>

#include "homolog/match/carry_animations.h"
#include "homolog/match/carry_texturing.h"

namespace homolog {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

template <class Value>
std::array<Value, 3> corners_of(const std::vector<Value>& values, const Triangle& triangle) {
  return {values[triangle[0]], values[triangle[1]], values[triangle[2]]};
}

Rgba colour_between(const std::array<Rgba, 3>& colours, const Vec3& barycentric) {
  Rgba colour{};
  for (int channel = 0; channel < 4; ++channel) {
    double value = 0;
    for (int k = 0; k < 3; ++k) value += barycentric[k] * colours[k][channel];
    colour[channel] = static_cast<float>(value);
  }
  return colour;
}

/// -1, or the next smaller number that is no label of the field.
double unused_label(const Field& field) {
  double least = 0;
  for (const double label : field.values) least = std::min(least, std::isnan(label) ? 0 : label);
  return least - 1;
}

}  // namespace

double value_between(const std::array<double, 3>& values, const Vec3& barycentric) {
  double sum = 0, share = 0;
  for (int k = 0; k < 3; ++k) {
    if (std::isnan(values[k])) continue;
    sum += barycentric[k] * values[k];
    share += barycentric[k];
  }
  return share >= 0.5 ? sum / share : none;
}

double label_between(const std::array<double, 3>& labels, const Vec3& barycentric) {
  double best = none, most = -1;
  for (int k = 0; k < 3; ++k) {
    double share = 0;
    for (int l = 0; l < 3; ++l) {
      if (labels[l] == labels[k] || (std::isnan(labels[l]) && std::isnan(labels[k]))) share += barycentric[l];
    }
    if (share > most) {
      most = share;
      best = labels[k];
    }
  }
  return best;
}

AttributedMesh carry_attributes(const AttributedMesh& giver, const Mesh& receiver, const std::vector<DensePlace>& places,
                                Chirality chirality) {
  AttributedMesh carried;
  carried.mesh = receiver;
  if (!giver.colours.empty()) carried.colours.assign(places.size(), no_colour);
  for (const Field& field : giver.fields) {
    carried.fields.push_back({field.name, field.kind, std::vector<double>(places.size(), none), unused_label(field)});
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i].is_there()) continue;
    const auto& triangle = giver.mesh.triangles[places[i].triangle];
    const Vec3& barycentric = places[i].barycentric;
    if (!giver.colours.empty()) carried.colours[i] = colour_between(corners_of(giver.colours, triangle), barycentric);
    for (std::size_t k = 0; k < giver.fields.size(); ++k) {
      const auto values = corners_of(giver.fields[k].values, triangle);
      const bool label = giver.fields[k].kind == Field::Kind::label;
      carried.fields[k].values[i] = label ? label_between(values, barycentric) : value_between(values, barycentric);
    }
  }
  if (!giver.texturing.corners.empty()) carried.texturing = carry_texturing(giver, receiver, places);
  if (!giver.rig.joints.empty()) carried.rig = carry_rig(giver, receiver, {places, chirality});
  carried.shape_keys = carry_shape_keys(giver, receiver, {places, chirality});
  carried.animations = carry_animations(giver, receiver, {places, chirality}, carried.rig);
  return carried;
}

}  // namespace homolog
