// SPDX-License-Identifier: MIT
#include "homolog/match/limbs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "homolog/match/contact.h"
#include "homolog/match/evidence.h"

namespace homolog {
namespace {

constexpr std::size_t least_ends = 3;
constexpr double farthest = 0.25;   // extents between ends that may belong together
constexpr double limb_share = 0.7;  // of the mean way from an end to the others: its limb
constexpr double unit = 0.2;        // of a limb

std::vector<Vec3> places_of(const Ends& ends, const std::vector<Vec3>& nodes) {
  std::vector<Vec3> places;
  for (const int node : ends.nodes) places.push_back(nodes[node]);
  return places;
}

// Which of the places is nearest; -1: all are too far.
int nearest_of(const std::vector<Vec3>& places, const Vec3& to, double too_far) {
  int found = -1;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double distance = (places[k] - to).norm();
    if (distance < too_far) too_far = distance, found = static_cast<int>(k);
  }
  return found;
}

// Length of the limb that ends in chosen[k].
double limb_length(const Ends& ends, const std::vector<int>& chosen, std::size_t k) {
  double sum = 0;
  for (const int other : chosen) sum += ends.ways(ends.nodes[other], chosen[k]);
  return limb_share * sum / static_cast<double>(chosen.size() - 1);
}

std::vector<LimbPlace> limb_places_of_nodes(const Shape& shape, const std::vector<int>& chosen) {
  std::vector<LimbPlace> places(shape.body.surface_count);
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const double length = limb_length(shape.ends, chosen, k);
    if (!std::isfinite(length)) continue;  // an end in another piece of the body
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double way = shape.ends.ways(static_cast<Eigen::Index>(i), chosen[k]);
      const auto out = static_cast<float>((1 - way / length) / unit);
      if (out > places[i].out) places[i] = {static_cast<float>(k), out};
    }
  }
  return places;
}

}  // namespace

EndsTogether ends_together(const Cloth& cloth, const Shape& model, const Shape& data) {
  const double too_far = farthest * extent_of(cloth, model, data);
  const std::vector<Vec3> laid = places_of(model.ends, cloth.nodes), there = places_of(data.ends, data.body.nodes);
  EndsTogether together;
  for (int a = 0; a < static_cast<int>(laid.size()); ++a) {
    const int b = nearest_of(there, laid[a], too_far);
    if (b >= 0 && nearest_of(laid, there[b], too_far) == a) together.model.push_back(a), together.data.push_back(b);
  }
  return together.model.size() < least_ends ? EndsTogether{} : together;
}

std::vector<LimbPlace> limb_places(const std::vector<SurfaceSample>& samples, const Shape& shape, const std::vector<int>& chosen) {
  const std::vector<LimbPlace> of_nodes = limb_places_of_nodes(shape, chosen);
  std::vector<LimbPlace> places;
  for (const SurfaceSample& sample : samples) {
    const int node = skin_node_at(shape.body, sample, std::numeric_limits<double>::infinity(), 0);
    places.push_back(of_nodes[std::max(node, 0)]);
  }
  return places;
}

}  // namespace homolog
