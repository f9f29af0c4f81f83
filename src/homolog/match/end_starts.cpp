// SPDX-License-Identifier: MIT
#include "homolog/match/end_starts.h"

#include <algorithm>
#include <cmath>

#include "homolog/base/distinct.h"
#include "homolog/base/parallel.h"
#include "homolog/match/end_pairs.h"

namespace homolog {
namespace {

constexpr std::size_t tried = 60;    // sets of paired ends
constexpr std::size_t placed = 80;   // skin samples that follow the ends
constexpr Eigen::Index middled = 8;  // samples whose mean is about the middle of a limb
constexpr double same_share = 0.04;  // mean distance of two starts, in data diagonals, below which they are one

// Ways from the skin to the chosen ends, as shares of the mean way between that end and the others: a longer limb is longer evenly.
Eigen::MatrixXd shares_of_ways(const Body& body, const Ends& ends, const std::vector<int>& chosen) {
  Eigen::MatrixXd shares(body.surface_count, chosen.size());
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    double between = 0;
    for (const int other : chosen) between += ends.ways(ends.nodes[other], chosen[k]);
    shares.col(k) = ends.ways.col(chosen[k]).head(body.surface_count) * (static_cast<double>(chosen.size() - 1) / between);
  }
  return shares;
}

// The mean of the skin samples with the most similar shares; near an end, the way to that end counts most.
Vec3 middle_at(const Eigen::RowVectorXd& share, const Eigen::MatrixXd& of_skin, const Body& body) {
  const Eigen::VectorXd weight = (share.array() + 0.1).inverse().transpose();
  const Eigen::VectorXd difference = (of_skin.rowwise() - share).cwiseAbs2() * weight;
  std::vector<int> order(body.surface_count);
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  const auto taken = static_cast<std::ptrdiff_t>(std::min<std::size_t>(middled, order.size()));
  const auto nearer = [&](int a, int b) { return difference[a] != difference[b] ? difference[a] < difference[b] : a < b; };
  std::partial_sort(order.begin(), order.begin() + taken, order.end(), nearer);
  Vec3 mean = Vec3::Zero();
  for (auto it = order.begin(); it != order.begin() + taken; ++it) mean += body.nodes[*it] / static_cast<double>(taken);
  return mean;
}

FollowedEnds follow(const EndPairs& ends, const Shape& model, const Shape& data) {
  std::vector<Vec3> from, to;
  std::vector<int> of_model, of_data;
  for (const auto& [a, b] : ends.pairs) {
    of_model.push_back(a);
    of_data.push_back(b);
    from.push_back(model.body.nodes[model.ends.nodes[a]]);
    to.push_back(data.body.nodes[data.ends.nodes[b]]);
  }
  const Eigen::MatrixXd here = shares_of_ways(model.body, model.ends, of_model), there = shares_of_ways(data.body, data.ends, of_data);
  for (std::size_t i = 0; i < std::min(placed, model.body.surface_count); ++i) {
    if (!here.row(i).allFinite()) continue;  // in another piece of the body
    from.push_back(middle_at(here.row(i), here, model.body));
    to.push_back(middle_at(here.row(i), there, data.body));
  }
  const std::vector<double> nugget(from.size(), model.body.spacing);
  return {SourceSystem(std::move(from), nugget), std::move(to)};
}

GrownSet start_of(const FollowedEnds& places, Chirality chirality) {
  GrownSet start;
  start.chirality = chirality;
  start.spline = ThinPlateSpline::similarity_free(places.model, places.data, chirality);
  return start;
}

double relative_energy(const GrownSet& start) { return start.spline.energy / std::pow(start.spline.similarity.scale, 2); }

bool same_start(const GrownSet& a, const GrownSet& b, const Shape& model, const Shape& data) {
  const std::size_t count = std::min(placed, model.body.surface_count);
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += (a.spline(model.body.nodes[i]) - b.spline(model.body.nodes[i])).norm();
  return sum < same_share * data.diagonal * static_cast<double>(count);
}

}  // namespace

std::vector<FollowedEnds> follow_ends(const Shape& model, const Shape& data) {
  const std::vector<EndPairs> sets = pair_ends(model.ends, data.ends, tried);
  std::vector<FollowedEnds> followed(sets.size());
  parallel_for(sets.size(), [&](std::size_t i) { followed[i] = follow(sets[i], model, data); });
  return followed;
}

std::vector<GrownSet> end_starts(const std::vector<FollowedEnds>& followed, const Shape& model, const Shape& data, Chirality chirality,
                                 std::size_t most) {
  std::vector<GrownSet> starts(followed.size());
  parallel_for(followed.size(), [&](std::size_t i) { starts[i] = start_of(followed[i], chirality); });
  std::stable_sort(starts.begin(), starts.end(),
                   [](const GrownSet& a, const GrownSet& b) { return relative_energy(a) < relative_energy(b); });
  return distinct(std::move(starts), most, [&](const GrownSet& a, const GrownSet& kept) { return same_start(a, kept, model, data); });
}

}  // namespace homolog
