// SPDX-License-Identifier: MIT
#include "homolog/match/region_starts.h"

#include <algorithm>
#include <cmath>

#include "homolog/base/distinct.h"
#include "homolog/base/parallel.h"

namespace homolog {
namespace {

constexpr Eigen::Index centres = 40;                    // of regions, an even prefix of the skin
constexpr double reaches[] = {0.18, 0.26, 0.37, 0.53};  // of regions, as shares of the longest way inside
constexpr std::size_t least_samples = 24;               // fewer show no form
constexpr double most_share = 0.85;                     // of the skin; more is the whole, which has starts of its own
constexpr std::size_t settled = 80;                     // ways to lay the model, after a rough look at all

double longest_way(const Body& body, Eigen::Index skin) {
  double longest = 0;
  for (Eigen::Index c = 0; c < std::min(centres, skin); ++c) {
    for (Eigen::Index i = 0; i < skin; ++i) {
      if (std::isfinite(body.ways(i, c))) longest = std::max(longest, body.ways(i, c));
    }
  }
  return longest;
}

struct Way {
  std::size_t region;
  Settled laid;
};

void sort_by_distance(std::vector<Way>& ways) {
  std::stable_sort(ways.begin(), ways.end(), [](const Way& x, const Way& y) { return x.laid.distance < y.laid.distance; });
}

// All ways to lay the model's axes on a region's.
std::vector<Way> rough_ways(const AxisSkin& model, const std::vector<AxisSkin>& regions, Chirality chirality) {
  std::vector<std::vector<Way>> of_region(regions.size());
  parallel_for(regions.size(), [&](std::size_t r) {
    for (const Similarity& s : axis_similarities(model, regions[r], chirality))
      of_region[r].push_back({r, rough_look(s, model, regions[r])});
  });
  std::vector<Way> ways;
  for (const std::vector<Way>& some : of_region) ways.insert(ways.end(), some.begin(), some.end());
  return ways;
}

}  // namespace

std::vector<AxisSkin> regions_of(const Body& body) {
  const auto skin = static_cast<Eigen::Index>(body.surface_count);
  const double longest = longest_way(body, skin);
  std::vector<AxisSkin> regions;
  for (const double reach : reaches) {
    for (Eigen::Index c = 0; c < std::min(centres, skin); ++c) {
      std::vector<SurfaceSample> region;
      for (Eigen::Index i = 0; i < skin; ++i) {
        if (body.ways(i, c) < reach * longest) region.push_back({body.nodes[i], body.normals[i]});
      }
      if (region.size() < least_samples || static_cast<double>(region.size()) > most_share * static_cast<double>(skin)) continue;
      regions.push_back(axis_skin(region, diagonal_of(region)));
    }
  }
  return regions;
}

std::vector<GrownSet> region_starts(const std::vector<AxisSkin>& regions, const Shape& model, const Shape& data, Chirality chirality,
                                    std::size_t most) {
  if (model.surface.empty() || data.surface.empty()) return {};
  const AxisSkin skin = axis_skin(model.surface, model.diagonal);
  std::vector<Way> ways = rough_ways(skin, regions, chirality);
  sort_by_distance(ways);
  ways.resize(std::min(ways.size(), settled));
  parallel_for(ways.size(),
               [&](std::size_t i) { ways[i].laid = settle(ways[i].laid.similarity, skin, regions[ways[i].region], chirality); });
  const std::vector<Settled> on_whole = ways_to_lay(skin, axis_skin(data.surface, data.diagonal), chirality, 1);
  std::erase_if(ways, [&](const Way& way) { return way.laid.distance > on_whole[0].distance; });
  sort_by_distance(ways);
  ways = distinct(std::move(ways), most, [&](const Way& x, const Way& kept) {
    return same_start(x.laid.similarity, kept.laid.similarity, skin, regions[kept.region].diagonal);
  });
  std::vector<GrownSet> starts;
  for (const Way& way : ways) starts.push_back(set_of(way.laid.similarity, chirality));
  return starts;
}

}  // namespace homolog
