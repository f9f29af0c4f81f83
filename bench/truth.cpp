// SPDX-License-Identifier: MIT
#include "truth.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace homolog::bench {
namespace {

constexpr std::size_t nearest_least = 12;
constexpr double nearest_radii = 1.5;
// Where vertices and landmarks are both known (poses of people and animals), 91 % of the points that pass these two are placed to
// within 5 % of the diagonal, of all points 83 %; 86 % pass.
constexpr double landmark_reach = 0.15;      // of the model landmarks' extent
constexpr double landmark_agreement = 0.05;  // of the data landmarks' extent
constexpr double landmark_blur = 0.05;       // of the model landmarks' extent

double extent(const std::vector<Vec3>& points) {
  Vec3 low = points.front(), high = points.front();
  for (const Vec3& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (high - low).norm();
}

// The true pairs around x: all within the distance, at least the nearest twelve.
Similarity local_similarity(const TrueMap& map, const Vec3& x, double distance) {
  std::vector<std::pair<double, std::size_t>> order(map.model.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = {(map.model[i] - x).squaredNorm(), i};
  const auto near_end = std::partition(order.begin(), order.end(), [&](const auto& o) { return o.first <= distance * distance; });
  auto count = static_cast<std::size_t>(near_end - order.begin());
  if (count < nearest_least) {
    count = std::min(nearest_least, order.size());
    std::nth_element(order.begin(), order.begin() + static_cast<long>(count) - 1, order.end());
  }
  std::vector<Vec3> model, data;
  for (std::size_t i = 0; i < count; ++i) {
    model.push_back(map.model[order[i].second]);
    data.push_back(map.data[order[i].second]);
  }
  return fit_similarity(model, data, map.mirrored);
}

// phi = -r with constants projected out; the similarity has taken the linear part.
void fit_spline(TrueMap& map) {
  const auto n = static_cast<Eigen::Index>(map.model.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 1, n + 1);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n + 1, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto a = static_cast<std::size_t>(i);
    for (Eigen::Index j = 0; j < n; ++j) system(i, j) = -(map.model[a] - map.model[static_cast<std::size_t>(j)]).norm();
    system(i, n) = system(n, i) = 1;
    right.row(i) = (map.data[a] - map.whole(map.model[a])).transpose();
  }
  // Least norm: two joints of a skeleton may share a place.
  const Eigen::MatrixXd solution = system.completeOrthogonalDecomposition().solve(right);
  for (Eigen::Index i = 0; i < n; ++i) map.weights.push_back(solution.row(i).transpose());
  map.constant = solution.row(n).transpose();
}

std::vector<Vec3> moved(const Similarity& turn, std::vector<Vec3> points) {
  for (Vec3& p : points) p = turn(p);
  return points;
}

// A box along the axes grows and shrinks as its points are turned, and what is judged must not change with that.
TrueMap make_map(const TruePoints& points, bool mirrored, const std::vector<Vec3>& data, const Similarity& model_turn,
                 const Similarity& data_turn) {
  TrueMap map;
  map.dense = points.dense;
  map.mirrored = mirrored;
  map.model = moved(model_turn, points.model);
  map.data = moved(data_turn, data);
  map.whole = fit_similarity(map.model, map.data, mirrored);
  map.model_extent = model_turn.scale * extent(points.model);
  map.data_extent = data_turn.scale * extent(data);
  if (!map.dense) fit_spline(map);
  return map;
}

Vec3 by_spline(const TrueMap& map, const Vec3& x) {
  Vec3 position = map.whole(x) + map.constant;
  for (std::size_t i = 0; i < map.model.size(); ++i) position -= (x - map.model[i]).norm() * map.weights[i];
  return position;
}

// Moving least squares: limbs move as their own landmarks do.
Vec3 by_near_landmarks(const TrueMap& map, const Vec3& x) {
  const double blur = landmark_blur * map.model_extent;
  std::vector<double> weights;
  for (const Vec3& landmark : map.model) weights.push_back(std::pow((landmark - x).squaredNorm() / (blur * blur) + 1, -2));
  return fit_similarity(map.model, map.data, map.mirrored, weights)(x);
}

std::optional<Placed> carry_by_landmarks(const TrueMap& map, const Vec3& x) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec3& landmark : map.model) nearest = std::min(nearest, (landmark - x).norm());
  const Vec3 position = by_near_landmarks(map, x);
  const double disagreement = (position - by_spline(map, x)).norm();
  if (nearest > landmark_reach * map.model_extent || disagreement > landmark_agreement * map.data_extent) return std::nullopt;
  return Placed{position, map.whole.scale};
}

}  // namespace

Truth make_truth(const TruePoints& points, const Similarity& model_turn, const Similarity& data_turn) {
  if (points.model.size() < 4 || points.model.size() != points.data.size()) {
    throw std::invalid_argument("a truth needs at least four pairs of true points");
  }
  Truth truth{make_map(points, points.mirrored, points.data, model_turn, data_turn), std::nullopt};
  if (!points.swapped_data.empty()) truth.swapped = make_map(points, !points.mirrored, points.swapped_data, model_turn, data_turn);
  return truth;
}

std::optional<Placed> carry(const TrueMap& map, const Vec3& model_position, double model_radius) {
  if (!map.dense) return carry_by_landmarks(map, model_position);
  const Similarity local = local_similarity(map, model_position, nearest_radii * model_radius);
  return Placed{local(model_position), local.scale};
}

}  // namespace homolog::bench
