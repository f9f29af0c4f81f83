// SPDX-License-Identifier: MIT
#include "homolog/match/family.h"

#include <algorithm>
#include <cmath>

#include "homolog/base/parallel.h"
#include "homolog/match/refine.h"

namespace homolog {
namespace {

constexpr std::size_t least_pairs = 4;  // three are unlikely to define good matchings (Sec. 6.2)
constexpr double same_map = 0.05;       // mean distance of two maps, in extents of the mapped model, below which they are one
constexpr double near_tie = 0.1;        // confidence within which the other handedness makes a match ambiguous

bool same_pair(const Correspondence& a, const Correspondence& b) { return a.model == b.model && a.data == b.data; }

std::size_t shared_pairs(const CorrespondenceSet& a, const CorrespondenceSet& b) {
  return std::count_if(a.begin(), a.end(), [&](const Correspondence& c) {
    return std::any_of(b.begin(), b.end(), [&](const Correspondence& d) { return same_pair(c, d); });
  });
}

double extent_of(const RefinedMatch& refined, const Shape& model, const Shape& data) {
  return std::min(data.diagonal, refined.match.similarity.scale * model.diagonal);
}

double mean_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).norm() / static_cast<double>(a.size());
  return sum;
}

// Share of a's mapped nodes that lie where b's do, whichever nodes those are: do both claim the same part of the data?
double overlap(const RefinedMatch& a, const RefinedMatch& b, double tolerance) {
  const auto is_covered = [&](const Vec3& node) {
    return std::any_of(b.cloth.nodes.begin(), b.cloth.nodes.end(),
                       [&](const Vec3& other) { return (node - other).squaredNorm() < tolerance * tolerance; });
  };
  return static_cast<double>(std::count_if(a.cloth.nodes.begin(), a.cloth.nodes.end(), is_covered)) /
         static_cast<double>(a.cloth.nodes.size());
}

// A match is ambiguous when its mirror image explains the same part of the data about as well.
void tell_handedness(std::vector<RefinedMatch>& all, const Shape& model, const Shape& data) {
  std::vector<Handedness> told;
  for (const RefinedMatch& a : all) {
    const bool ambiguous = std::any_of(all.begin(), all.end(), [&](const RefinedMatch& b) {
      return a.cloth.chirality != b.cloth.chirality && b.match.confidence > a.match.confidence - near_tie &&
             overlap(a, b, 0.1 * extent_of(a, model, data)) > 0.6;
    });
    told.push_back(ambiguous ? Handedness::ambiguous : a.match.handedness);
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i].match.handedness = told[i];
}

bool allowed(Chirality chirality, Mirror mirror) {
  return mirror == Mirror::allow || (mirror == Mirror::only) == (chirality == Chirality::mirrored);
}

bool better(const RefinedMatch& a, const RefinedMatch& b) {
  if (a.match.confidence != b.match.confidence) return a.match.confidence > b.match.confidence;
  return a.match.pairs.size() > b.match.pairs.size();
}

}  // namespace

const char* handedness_name(Handedness handedness) {
  switch (handedness) {
    case Handedness::proper:
      return "proper";
    case Handedness::mirrored:
      return "mirrored";
    default:
      return "ambiguous";
  }
}

std::vector<GrownSet> distinct_sets(std::vector<GrownSet> sets, std::size_t most) {
  std::stable_sort(sets.begin(), sets.end(), [](const GrownSet& a, const GrownSet& b) { return a.score > b.score; });
  std::vector<GrownSet> distinct;
  for (GrownSet& set : sets) {
    if (distinct.size() == most) break;
    if (set.pairs.size() < least_pairs) continue;
    const bool known = std::any_of(distinct.begin(), distinct.end(), [&](const GrownSet& other) {
      return other.chirality == set.chirality && 2 * shared_pairs(set.pairs, other.pairs) > set.pairs.size();
    });
    if (!known) distinct.push_back(std::move(set));
  }
  return distinct;
}

Family make_family(const std::vector<GrownSet>& sets, const Shape& model, const Shape& data, const Params& params, bool without_identity) {
  std::vector<RefinedMatch> refined(sets.size());
  parallel_for(sets.size(), [&](std::size_t i) { refined[i] = refine_set(sets[i], model, data, params); });
  std::stable_sort(refined.begin(), refined.end(), better);
  std::vector<RefinedMatch> kept;
  for (RefinedMatch& candidate : refined) {
    if (candidate.match.pairs.size() < least_pairs) continue;
    const double tolerance = same_map * extent_of(candidate, model, data);
    if (without_identity && mean_distance(candidate.cloth.nodes, model.body.nodes) < tolerance) continue;
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const RefinedMatch& other) {
      return other.cloth.chirality == candidate.cloth.chirality && mean_distance(candidate.cloth.nodes, other.cloth.nodes) < tolerance;
    });
    if (!known) kept.push_back(std::move(candidate));
  }
  tell_handedness(kept, model, data);
  Family family;
  for (const RefinedMatch& r : kept) {
    if (allowed(r.cloth.chirality, params.match.mirror) && static_cast<int>(family.matches.size()) < params.match.matches) {
      family.matches.push_back(r.match);
    }
  }
  return family;
}

}  // namespace homolog
