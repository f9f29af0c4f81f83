// SPDX-License-Identifier: MIT
#include "instances.h"

#include <algorithm>
#include <optional>
#include <tuple>

namespace homolog::bench {
namespace {

constexpr double claimed_confidence = 0.5;

struct Hit {
  std::size_t instance;
  bool swapped;
};

// What tolerances and errors are shares of: the data, or the copy's own size where there are several.
double diagonal_of(const std::vector<Truth>& truths, std::size_t i, double data_diagonal) {
  const TrueMap& map = truths[i].direct;
  return truths.size() > 1 ? map.whole.scale * map.model_extent : data_diagonal;
}

// The instance for which the match is right, if any; with several, the one with most right pairs.
std::optional<Hit> hit_of(const Match& match, const std::vector<Truth>& truths, double data_diagonal) {
  std::optional<Hit> hit;
  int most = 0;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const MatchScore score = score_match(match, truths[i], diagonal_of(truths, i, data_diagonal));
    if (!score.success || score.right <= most) continue;
    most = score.right;
    hit = Hit{i, score.swapped};
  }
  return hit;
}

void count_instances(const Family& family, const std::vector<Truth>& truths, double data_diagonal, PairScore& score) {
  std::vector<std::optional<bool>> found(truths.size());  // by its direct or its swapped answer
  for (const Match& match : family.matches) {
    if (match.confidence < claimed_confidence) continue;
    const auto hit = hit_of(match, truths, data_diagonal);
    const bool again = hit && found[hit->instance].has_value();
    if (again && *found[hit->instance] != hit->swapped) continue;
    ++score.instances_claimed;
    if (!hit || again) continue;
    found[hit->instance] = hit->swapped;
    ++score.instances_right;
  }
}

}  // namespace

PairScore score_instances(const Family& family, const Points& model, const Points& data, const std::vector<Truth>& truths,
                          double data_diagonal) {
  const auto merit = [](const PairScore& s) { return std::tuple(s.success, s.first.right, s.success_in_six, s.findable); };
  PairScore best;
  int first_right = 0;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    PairScore score = score_family(family, model, data, truths[i], diagonal_of(truths, i, data_diagonal));
    if (score.first_right > 0 && (first_right == 0 || score.first_right < first_right)) first_right = score.first_right;
    if (i == 0 || merit(score) > merit(best)) best = std::move(score);
  }
  best.first_right = first_right;
  if (!best.success && first_right > 0) best.lost = Stage::ranking;
  best.instances = static_cast<int>(truths.size());
  count_instances(family, truths, data_diagonal, best);
  return best;
}

PairScore score_unrelated(const Family& family, const Points& model, const Points& data) {
  PairScore score;
  score.model_points = static_cast<int>(model.size());
  score.data_points = static_cast<int>(data.size());
  score.matches = static_cast<int>(family.matches.size());
  score.found = !family.matches.empty();
  score.instances_claimed =
      static_cast<int>(std::ranges::count_if(family.matches, [](const Match& m) { return m.confidence >= claimed_confidence; }));
  if (score.found) {
    score.confidence = family.matches.front().confidence;
    score.handedness = family.matches.front().handedness;
    score.first.pairs = static_cast<int>(family.matches.front().pairs.size());
  }
  score.success = score.instances_claimed == 0;
  if (score.success) score.lost = Stage::ok;
  return score;
}

double instance_f1(const PairScore& score) {
  const int all = score.instances + score.instances_claimed;
  return all > 0 ? 2.0 * score.instances_right / all : 1;
}

}  // namespace homolog::bench
