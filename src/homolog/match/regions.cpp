// SPDX-License-Identifier: MIT
#include "homolog/match/regions.h"

#include <algorithm>
#include <cmath>

namespace homolog {
namespace {

constexpr std::size_t asked = 40;          // samples; ends lie near one of so many
constexpr std::size_t least_samples = 24;  // fewer show no form
constexpr double most_share = 0.85;        // of the skin; more is the whole, which has starts of its own

}  // namespace

double longest_way_from(const Body& body, std::size_t node) {
  double longest = 0;
  for (std::size_t i = 0; i < body.surface_count; ++i) {
    if (std::isfinite(body.ways(i, node))) longest = std::max(longest, body.ways(i, node));
  }
  return longest;
}

double longest_way(const Body& body) {
  double longest = 0;
  for (std::size_t c = 0; c < std::min(asked, body.surface_count); ++c) longest = std::max(longest, longest_way_from(body, c));
  return longest;
}

std::vector<Region> regions_of(const Body& body, std::size_t centres, std::span<const double> reaches) {
  const double longest = longest_way(body);
  std::vector<Region> regions;
  for (const double reach : reaches) {
    for (std::size_t c = 0; c < std::min(centres, body.surface_count); ++c) {
      std::vector<SurfaceSample> region;
      for (std::size_t i = 0; i < body.surface_count; ++i) {
        if (body.ways(i, c) < reach * longest) region.push_back({body.nodes[i], body.normals[i]});
      }
      if (region.size() < least_samples) continue;
      if (static_cast<double>(region.size()) > most_share * static_cast<double>(body.surface_count)) continue;
      regions.push_back({c, axis_skin(region, diagonal_of(region))});
    }
  }
  return regions;
}

}  // namespace homolog
