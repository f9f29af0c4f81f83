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
constexpr double farthest = 0.25;  // extents between ends that may belong together
constexpr double unit = 0.15;      // of a limb

// Which of the places is nearest; -1: all are too far.
int nearest_of(const std::vector<Vec3>& places, const Vec3& to, double too_far) {
  int found = -1;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double distance = (places[k] - to).norm();
    if (distance < too_far) too_far = distance, found = static_cast<int>(k);
  }
  return found;
}

std::vector<LimbPlace> limb_places_of_nodes(const Shape& shape, const std::vector<int>& chosen) {
  const std::vector<double> lengths = limb_lengths(shape.ends, chosen);
  std::vector<LimbPlace> places(shape.body.surface_count);
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    if (!is_length(lengths[k])) continue;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double way = shape.ends.ways(static_cast<Eigen::Index>(i), chosen[k]);
      const auto out = static_cast<float>((1 - way / lengths[k]) / unit);
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

std::vector<Vec3> places_of(const Ends& ends, const std::vector<Vec3>& nodes, std::size_t most) {
  std::vector<Vec3> places;
  for (std::size_t k = 0; k < std::min(most, ends.nodes.size()); ++k) places.push_back(nodes[ends.nodes[k]]);
  return places;
}

double way_between(const Ends& ends, int a, int b) { return ends.ways(ends.nodes[a], b); }

EndsTogether joined(EndsTogether first, const EndsTogether& second) {
  first.model.insert(first.model.end(), second.model.begin(), second.model.end());
  first.data.insert(first.data.end(), second.data.begin(), second.data.end());
  return first;
}

bool is_length(double length) { return length > 0 && std::isfinite(length); }

std::vector<double> limb_lengths(const Ends& ends, const std::vector<int>& chosen) {
  std::vector<double> lengths;
  for (const int end : chosen) {
    double& least = lengths.emplace_back(std::numeric_limits<double>::infinity());
    for (const int a : chosen) {
      for (const int b : chosen) {
        if (a >= b || a == end || b == end) continue;
        least = std::min(least, 0.5 * (way_between(ends, end, a) + way_between(ends, end, b) - way_between(ends, a, b)));
      }
    }
  }
  return lengths;
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
