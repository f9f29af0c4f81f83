// SPDX-License-Identifier: MIT
#include "score.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "homolog/shape/vertex_normals.h"
#include "surface_ways.h"

namespace homolog::bench {
namespace {

constexpr double radius_share = 0.5, diagonal_share = 0.05, radius_factor = 1.65;
constexpr int least_right = 4, first_ranks = 6;
constexpr double right_share = 0.7;
constexpr std::size_t transfer_points = 2000;

bool within_tolerance(const Vec3& placed, const SalientPoint& data, double diagonal) {
  return (placed - data.position).norm() <= std::max(radius_share * data.radius, diagonal_share * diagonal);
}

bool is_partner(const Placed& placed, const SalientPoint& model, const SalientPoint& data, double diagonal) {
  const double ratio = data.radius / (model.radius * placed.scale);
  return ratio <= radius_factor && ratio >= 1 / radius_factor && within_tolerance(placed.position, data, diagonal);
}

// Per pair: is one of its two points in another pair too?
std::vector<bool> uses_point_twice(const std::vector<Correspondence>& pairs) {
  std::map<int, int> model_uses, data_uses;
  for (const Correspondence& c : pairs) ++model_uses[c.model], ++data_uses[c.data];
  std::vector<bool> twice;
  for (const Correspondence& c : pairs) twice.push_back(model_uses[c.model] > 1 || data_uses[c.data] > 1);
  return twice;
}

struct Tally {
  int judged = 0, right = 0;
  bool success() const { return right >= least_right && right >= right_share * judged; }
};

Tally tally(const Match& match, const TrueMap& truth, double diagonal) {
  const std::vector<bool> twice = uses_point_twice(match.pairs);
  Tally count;
  for (std::size_t i = 0; i < match.pairs.size(); ++i) {
    const Correspondence& c = match.pairs[i];
    const auto placed = carry(truth, c.model_point.position, c.model_point.radius);
    if (!placed && !twice[i]) continue;
    ++count.judged;
    if (!twice[i] && within_tolerance(placed->position, c.data_point, diagonal)) ++count.right;
  }
  return count;
}

int count_findable_found(const Match& match, const TrueMap& truth, double diagonal) {
  int count = 0;
  for (const Correspondence& c : match.pairs) {
    const auto placed = carry(truth, c.model_point.position, c.model_point.radius);
    if (placed && is_partner(*placed, c.model_point, c.data_point, diagonal)) ++count;
  }
  return count;
}

Stage stage_of_loss(const PairScore& score) {
  if (score.success) return Stage::ok;
  if (score.first_right > 0) return Stage::ranking;
  return score.findable >= least_right ? Stage::family : Stage::points;
}

}  // namespace

const char* stage_name(Stage stage) {
  switch (stage) {
    case Stage::points:
      return "points";
    case Stage::family:
      return "family";
    case Stage::ranking:
      return "ranking";
    case Stage::ok:
      return "ok";
  }
  return "";
}

MatchScore score_match(const Match& match, const Truth& truth, double data_diagonal) {
  const Tally direct = tally(match, truth.direct, data_diagonal);
  const Tally swapped = truth.swapped ? tally(match, *truth.swapped, data_diagonal) : Tally{};
  MatchScore score;
  score.swapped = swapped.right > direct.right;
  const Tally& better = score.swapped ? swapped : direct;
  score.pairs = static_cast<int>(match.pairs.size());
  score.judged = better.judged;
  score.right = better.right;
  score.right_direct = direct.right;
  score.success_direct = direct.success();
  score.success = direct.success() || swapped.success();
  return score;
}

TransferScore score_transfer(const ThinPlateSpline& data_from_model, const TrueMap& truth, double data_diagonal) {
  const std::size_t step = std::max<std::size_t>(1, truth.model.size() / transfer_points);
  std::vector<double> errors;
  for (std::size_t i = 0; i < truth.model.size(); i += step) {
    errors.push_back((data_from_model(truth.model[i]) - truth.data[i]).norm() / data_diagonal);
  }
  std::sort(errors.begin(), errors.end());
  const auto n = static_cast<double>(errors.size());
  const auto within = [&](double limit) {
    return static_cast<double>(std::ranges::count_if(errors, [&](double e) { return e <= limit; })) / n;
  };
  TransferScore score;
  score.median = (errors[(errors.size() - 1) / 2] + errors[errors.size() / 2]) / 2;
  score.mean = std::accumulate(errors.begin(), errors.end(), 0.0) / n;
  score.within_05 = within(0.05);
  score.within_10 = within(0.10);
  return score;
}

std::vector<double> errors_along_surface(const ThinPlateSpline& data_from_model, const TrueMap& truth, const Mesh& data) {
  const SurfaceWays ways(data);
  const NearestSurface surface(data, vertex_normals(data));
  const auto place = [&](const Vec3& x) { return *surface.nearest(x, Vec3::Zero(), std::numeric_limits<double>::infinity()); };
  const double unit = std::sqrt(area_of(data));
  std::vector<double> errors;
  for (std::size_t i = 0; i < truth.model.size(); ++i) {
    const SurfacePlace meant = place(truth.data[i]);
    errors.push_back(ways.to(place(data_from_model(truth.model[i])), meant, ways.from(meant)) / unit);
  }
  return errors;
}

int count_findable(const Points& model, const Points& data, const TrueMap& truth, double data_diagonal) {
  int count = 0;
  for (const SalientPoint& m : model) {
    const auto placed = carry(truth, m.position, m.radius);
    count +=
        placed && std::any_of(data.begin(), data.end(), [&](const SalientPoint& d) { return is_partner(*placed, m, d, data_diagonal); });
  }
  return count;
}

PairScore score_family(const Family& family, const Points& model, const Points& data, const Truth& truth, double data_diagonal) {
  PairScore score;
  score.model_points = static_cast<int>(model.size());
  score.data_points = static_cast<int>(data.size());
  score.matches = static_cast<int>(family.matches.size());
  score.has_swap = truth.swapped.has_value();
  for (std::size_t rank = 1; rank <= family.matches.size() && score.first_right == 0; ++rank) {
    if (score_match(family.matches[rank - 1], truth, data_diagonal).success) score.first_right = static_cast<int>(rank);
  }
  score.success_in_six = score.first_right > 0 && score.first_right <= first_ranks;
  if (!family.matches.empty()) {
    const Match& first = family.matches.front();
    score.found = true;
    score.first = score_match(first, truth, data_diagonal);
    score.success = score.first.success;
    score.success_direct = score.first.success_direct;
    const TrueMap& met = truth.answer(score.first.swapped);
    score.transfer = score_transfer(first.data_from_model, met, data_diagonal);
    score.findable_found = count_findable_found(first, met, data_diagonal);
    score.confidence = first.confidence;
    score.handedness = first.handedness;
    score.handedness_right = (first.handedness == Handedness::mirrored) == met.mirrored && first.handedness != Handedness::ambiguous;
  }
  const TrueMap& sought = truth.answer(score.first.swapped);
  score.findable = count_findable(model, data, sought, data_diagonal);
  score.lost = stage_of_loss(score);
  return score;
}

}  // namespace homolog::bench
