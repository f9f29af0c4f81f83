// SPDX-License-Identifier: MIT
#include "homolog/match/region_starts.h"

#include <algorithm>
#include <limits>

#include "homolog/base/distinct.h"
#include "homolog/base/parallel.h"

namespace homolog {
namespace {

constexpr std::size_t centres = 40, model_centres = 8;
constexpr double reaches[] = {0.18, 0.26, 0.37, 0.53};
constexpr double model_reaches[] = {0.45};                  // large enough to show a form, small enough not to bend
constexpr std::size_t settled = 80, settled_outward = 160;  // ways to lay the model or its regions, after a rough look at all
constexpr double least_whole = 0.2, most_whole = 0.85;      // longest way of the whole model laid by a region, in the data's: a part of it

struct Way {
  const Region* from;  // of the model
  const Region* onto;  // of the data
  Settled laid;
};

void sort_by_distance(std::vector<Way>& ways) {
  std::stable_sort(ways.begin(), ways.end(), [](const Way& x, const Way& y) { return x.laid.distance < y.laid.distance; });
}

// All ways to lay the axes of one region on another's, roughly looked at.
std::vector<Way> rough_ways(const Region& from, const Region& onto, Chirality chirality) {
  std::vector<Way> ways;
  for (const Similarity& s : axis_similarities(from.skin, onto.skin, chirality)) {
    ways.push_back({&from, &onto, rough_look(s, from.skin, onto.skin)});
  }
  return ways;
}

// Of the ways to lay each model region on each of the data's that it may lie on, `most` are settled, the best first; none that lies farther
// than `farthest`.
template <class MayLie>
std::vector<Way> settled_ways(const std::vector<Region>& model, const std::vector<Region>& data, Chirality chirality, std::size_t most,
                              double farthest, const MayLie& may_lie) {
  std::vector<std::vector<Way>> of_pair(model.size() * data.size());
  parallel_for(of_pair.size(), [&](std::size_t p) {
    const Region &from = model[p / data.size()], &onto = data[p % data.size()];
    if (may_lie(from, onto)) of_pair[p] = rough_ways(from, onto, chirality);
  });
  std::vector<Way> ways;
  for (const std::vector<Way>& some : of_pair) ways.insert(ways.end(), some.begin(), some.end());
  sort_by_distance(ways);
  ways.resize(std::min(ways.size(), most));
  parallel_for(ways.size(),
               [&](std::size_t i) { ways[i].laid = settle(ways[i].laid.similarity, ways[i].from->skin, ways[i].onto->skin, chirality); });
  std::erase_if(ways, [&](const Way& way) { return way.laid.distance > farthest; });
  sort_by_distance(ways);
  return ways;
}

}  // namespace

std::vector<Region> regions_to_lay_on(const Body& data) { return regions_of(data, centres, reaches); }

double distance_on_whole(const Shape& model, const Shape& data, Chirality chirality) {
  if (model.surface.empty() || data.surface.empty()) return std::numeric_limits<double>::infinity();
  return ways_to_lay(axis_skin(model.surface, model.diagonal), axis_skin(data.surface, data.diagonal), chirality, 1)[0].distance;
}

std::vector<GrownSet> region_starts(const std::vector<Region>& regions, const Shape& model, Chirality chirality, double farthest,
                                    std::size_t most) {
  if (model.surface.empty()) return {};
  const std::vector<Region> whole{{0, axis_skin(model.surface, model.diagonal)}};
  const AxisSkin& skin = whole[0].skin;
  std::vector<Way> ways = settled_ways(whole, regions, chirality, settled, farthest, [](const Region&, const Region&) { return true; });
  ways = distinct(std::move(ways), most, [&](const Way& x, const Way& kept) {
    return same_start(x.laid.similarity, kept.laid.similarity, skin, kept.onto->skin.diagonal);
  });
  std::vector<GrownSet> starts;
  for (const Way& way : ways) starts.push_back(set_of(way.laid.similarity, chirality));
  return starts;
}

std::vector<GrownSet> outward_starts(const std::vector<Region>& regions, const Shape& model, const Shape& data, Chirality chirality,
                                     double farthest, std::size_t most) {
  if (model.surface.empty()) return {};
  const std::vector<Region> of_model = regions_of(model.body, model_centres, model_reaches);
  const double longer = longest_way(model.body) / longest_way(data.body);
  const auto may_lie = [&](const Region& from, const Region& onto) {
    const double whole = longer * onto.skin.radius / from.skin.radius;
    return least_whole < whole && whole < most_whole;
  };
  const AxisSkin skin = axis_skin(model.surface, model.diagonal);
  std::vector<Way> ways = settled_ways(of_model, regions, chirality, settled_outward, farthest, may_lie);
  ways = distinct(std::move(ways), most, [&](const Way& x, const Way& kept) {
    return same_start(x.laid.similarity, kept.laid.similarity, skin, kept.laid.similarity.scale * model.diagonal);
  });
  std::vector<GrownSet> starts;
  for (const Way& way : ways) {
    starts.push_back(set_of(way.laid.similarity, chirality));
    starts.back().drawn_from = way.from->centre;
  }
  return starts;
}

}  // namespace homolog
