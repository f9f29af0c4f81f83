// SPDX-License-Identifier: MIT
#include "homolog/match/family.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "homolog/base/distinct.h"
#include "homolog/base/parallel.h"
#include "homolog/match/evidence.h"
#include "homolog/match/refine.h"

namespace homolog {
namespace {

constexpr std::size_t least_pairs = 4;  // told ones; three are unlikely to define good matchings (Sec. 6.2)
constexpr std::size_t least_grown = 3;  // but guiding and following may find them more
constexpr double same_map = 0.05;       // mean distance of two maps, in extents of the mapped model, below which they are one
constexpr double same_start = 0.04;     // the same for grown sets, at the salient points
constexpr double rivalry = 12;          // log of odds per merit between matches that claim the same part of the data (merit_of's fit)
constexpr std::size_t compared = 150;   // nodes of each
constexpr double near_tie = 0.15;       // merit within which the other handedness makes a match ambiguous

// Most sets fall behind early: after so many steps of the first draw only so many stay, and none that is behind by more merit than this
// another that claims the same part of the data.
struct Heat {
  int steps;
  std::size_t most;
  double most_behind;
};
constexpr Heat heats[] = {{3, 40, 0.6}, {6, 24, 0.4}, {first_steps, 16, 0.3}};

std::size_t shared_pairs(const CorrespondenceSet& a, const CorrespondenceSet& b) {
  return std::count_if(a.begin(), a.end(), [&](const Correspondence& c) {
    return std::any_of(b.begin(), b.end(), [&](const Correspondence& d) { return c.model == d.model && c.data == d.data; });
  });
}

double mean_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).norm() / static_cast<double>(a.size());
  return sum;
}

// Does a proper map pair most points with themselves? Where many lie together, as on a head, they are not half of the nodes.
bool keeps_its_points(const Refined& match) {
  const auto own = std::count_if(match.pairs.begin(), match.pairs.end(), [](const Correspondence& c) { return c.model == c.data; });
  return match.cloth.chirality == Chirality::proper && 2 * own > std::ssize(match.pairs);
}

// Does most of the model stay where it is? A proper map that leaves half of the nodes there exchanges a limb at most.
bool stays(const Cloth& cloth, const Shape& model) {
  if (cloth.chirality == Chirality::mirrored) return mean_distance(cloth.nodes, model.body.nodes) < same_map * model.diagonal;
  std::size_t staying = 0;
  for (std::size_t i = 0; i < cloth.nodes.size(); ++i) staying += (cloth.nodes[i] - model.body.nodes[i]).norm() < same_map * model.diagonal;
  return 2 * staying > cloth.nodes.size();
}

double rank_merit(const Refined& match) { return rank_merit(match.evidence, match.cloth.chirality); }

bool better(const Refined& a, const Refined& b) {
  if (rank_merit(a) != rank_merit(b)) return rank_merit(a) > rank_merit(b);
  return a.pairs.size() > b.pairs.size();
}

// Best first; of several drawn to the same map the best one stays.
std::vector<Refined> without_duplicates(std::vector<Refined> all, const Shape& model, const Shape& data) {
  std::stable_sort(all.begin(), all.end(), better);
  const std::size_t count = all.size();
  return distinct(std::move(all), count, [&](const Refined& candidate, const Refined& kept) {
    const double tolerance = same_map * extent_of(candidate.cloth, model, data);
    return kept.cloth.chirality == candidate.cloth.chirality && mean_distance(candidate.cloth.nodes, kept.cloth.nodes) < tolerance;
  });
}

// Share of a's mapped skin that lies where b's does, whichever nodes those are: do both claim the same part of the data?
double overlap(const Cloth& a, const Cloth& b, double tolerance) {
  const std::size_t count = std::min(compared, a.nodes.size());  // a prefix of the nodes is even
  std::size_t covered = 0;
  for (std::size_t i = 0; i < count; ++i) {
    covered += std::any_of(b.nodes.begin(), b.nodes.begin() + static_cast<std::ptrdiff_t>(count),
                           [&](const Vec3& other) { return (a.nodes[i] - other).squaredNorm() < tolerance * tolerance; });
  }
  return static_cast<double>(covered) / static_cast<double>(count);
}

bool same_part(const Refined& match, const Refined& other, const Shape& model, const Shape& data) {
  return overlap(match.cloth, other.cloth, 0.1 * extent_of(match.cloth, model, data)) > 0.6;
}

// `all` come best first. A mirrored one that shall not be told leaves the others alone.
std::vector<Refined> without_lagging(std::vector<Refined> all, double most_behind, const Shape& model, const Shape& data, Mirror mirror) {
  const std::size_t count = all.size();
  return distinct(std::move(all), count, [&](const Refined& candidate, const Refined& kept) {
    return merit_of(kept.evidence) - merit_of(candidate.evidence) > most_behind && allowed(kept.cloth.chirality, mirror) &&
           same_part(candidate, kept, model, data);
  });
}

double odds(double merit, double better) { return std::exp(rivalry * std::min(0.0, merit - better)); }

// In how many ways the part that a match claims can be laid about as well.
double ways_of(const Refined& match, const std::vector<Refined>& all, const Shape& model, const Shape& data) {
  double ways = 1;
  for (const Refined& rival : all) {
    if (&rival != &match && same_part(match, rival, model, data)) ways += odds(rank_merit(rival), rank_merit(match));
  }
  return ways;
}

// Of matches that claim the same part of the data one is right, and those as good are symmetric to it: a worse one is believed by the
// odds between them. `all` come best first.
std::vector<double> odds_against_rivals(const std::vector<Refined>& all, const Shape& model, const Shape& data) {
  std::vector<double> against(all.size(), 1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto better_end = all.begin() + static_cast<std::ptrdiff_t>(i);
    const auto rival = std::find_if(all.begin(), better_end, [&](const Refined& r) { return same_part(all[i], r, model, data); });
    if (rival != better_end) against[i] = odds(merit_of(all[i].evidence), merit_of(rival->evidence));
  }
  return against;
}

// `all` come best first by merit and leave so by belief: other copies of the model come before worse ways to lay it on the first one. The
// more ways are as good as the one believed most, the less all are believed, unless each of them is a symmetry of one shape. Only those
// count: how many ways are known to lay the model elsewhere tells more of the search.
std::vector<Refined> believed(std::vector<Refined> all, const Shape& model, const Shape& data, bool symmetries) {
  const auto less_sure = [](const Refined& a, const Refined& b) { return a.confidence < b.confidence; };
  const std::vector<double> against = odds_against_rivals(all, model, data);
  const auto believe = [&](double ways) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].confidence = confidence_of(all[i].evidence, all[i].cloth.chirality, ways) * against[i];
    }
  };
  believe(1);
  if (!all.empty() && !symmetries) believe(ways_of(*std::max_element(all.begin(), all.end(), less_sure), all, model, data));
  std::stable_sort(all.begin(), all.end(), [&](const Refined& a, const Refined& b) { return less_sure(b, a); });
  return all;
}

// A match is ambiguous when its mirror image explains the same part of the data about as well.
bool is_ambiguous(const Refined& match, const std::vector<Refined>& all, const Shape& model, const Shape& data) {
  return std::any_of(all.begin(), all.end(), [&](const Refined& other) {
    return match.cloth.chirality != other.cloth.chirality && std::abs(merit_of(other.evidence) - merit_of(match.evidence)) < near_tie &&
           same_part(match, other, model, data);
  });
}

struct LaidSet {
  GrownSet set;
  std::vector<Vec3> image;  // of the model's points
};

std::vector<Refined> refine_all(const std::vector<GrownSet>& sets, const Shape& model, const Shape& data, const Params& params,
                                bool without_identity, Stopwatch* watch) {
  const auto is_identity = [&](const Refined& r) { return stays(r.cloth, model); };
  std::vector<Refined> refined(sets.size());
  parallel_for(sets.size(), [&](std::size_t i) { refined[i] = lay_set(sets[i], model, data); });
  int begin = 0;
  for (const auto& [end, most, most_behind] : heats) {
    parallel_for(refined.size(), [&](std::size_t i) { draw_set(refined[i], model, data, params.descriptor.kind, begin, end); });
    refined = without_duplicates(std::move(refined), model, data);
    refined.resize(std::min(refined.size(), most));
    if (without_identity) std::erase_if(refined, is_identity);
    refined = without_lagging(std::move(refined), most_behind, model, data, params.match.mirror);
    lap(watch, fmt::format("draws {} to {}", begin + 1, end), refined.size(), "maps left");
    begin = end;
  }
  parallel_for(refined.size(), [&](std::size_t i) { guide_pairs(refined[i], model, data, params.descriptor.kind); });
  if (without_identity) std::erase_if(refined, [&](const Refined& r) { return is_identity(r) || keeps_its_points(r); });
  refined = without_duplicates(std::move(refined), model, data);
  lap(watch, "guided pairs", refined.size(), "maps left");
  return refined;
}

// The followed points of the last match join the data's.
void number_followed(Family& family, const Shape& data) {
  for (Correspondence& c : family.matches.back().pairs) {
    if (c.data >= 0) continue;
    c.data = static_cast<int>(data.points.size() + family.followed.size());
    family.followed.push_back(c.data_point);
  }
}

}  // namespace

std::vector<GrownSet> distinct_sets(std::vector<GrownSet> sets, std::size_t most, const Shape& model) {
  std::erase_if(sets, [](const GrownSet& set) { return set.pairs.size() < least_grown; });
  std::stable_sort(sets.begin(), sets.end(), [](const GrownSet& a, const GrownSet& b) { return a.score > b.score; });
  std::vector<LaidSet> laid;
  for (GrownSet& set : sets) {
    laid.push_back({std::move(set), {}});
    for (const SalientPoint& point : model.points) laid.back().image.push_back(laid.back().set.spline(point.position));
  }
  laid = distinct(std::move(laid), most, [&](const LaidSet& candidate, const LaidSet& kept) {
    const GrownSet &a = candidate.set, &b = kept.set;
    if (a.chirality != b.chirality) return false;
    const double tolerance = same_start * a.spline.similarity.scale * model.diagonal;
    return 2 * shared_pairs(a.pairs, b.pairs) > a.pairs.size() || mean_distance(candidate.image, kept.image) < tolerance;
  });
  sets.clear();
  for (LaidSet& l : laid) sets.push_back(std::move(l.set));
  return sets;
}

bool allowed(Chirality chirality, Mirror mirror) {
  return mirror == Mirror::allow || (mirror == Mirror::only) == (chirality == Chirality::mirrored);
}

Family make_family(const std::vector<GrownSet>& sets, const Shape& model, const Shape& data, const Params& params, bool without_identity,
                   Stopwatch* watch) {
  const std::vector<Refined> refined = refine_all(sets, model, data, params, without_identity, watch);
  std::vector<Refined> told = refined;
  std::erase_if(told, [&](const Refined& r) { return !allowed(r.cloth.chirality, params.match.mirror); });
  told = believed(std::move(told), model, data, without_identity);
  std::vector<Match> matches(told.size());
  parallel_for(told.size(), [&](std::size_t i) {
    finish(told[i], model, data, params.descriptor.kind);
    matches[i] = match_of(told[i], model, data, params);
  });
  Family family;
  for (std::size_t i = 0; i < told.size(); ++i) {
    if (static_cast<int>(family.matches.size()) == params.match.matches) break;
    if (matches[i].pairs.size() < least_pairs) continue;
    family.matches.push_back(std::move(matches[i]));
    number_followed(family, data);
    if (is_ambiguous(told[i], refined, model, data)) family.matches.back().handedness = Handedness::ambiguous;
  }
  lap(watch, "limbs, warps", family.matches.size(), "matches");
  return family;
}

}  // namespace homolog
