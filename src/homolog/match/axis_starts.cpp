// SPDX-License-Identifier: MIT
#include "homolog/match/axis_starts.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "homolog/base/distinct.h"
#include "homolog/base/parallel.h"
#include "homolog/match/best_similarity.h"

namespace homolog {
namespace {

constexpr std::size_t samples = 150;  // of each skin
constexpr int settle_steps = 12;
constexpr double different = 0.15;  // mean distance of two starts, in data diagonals, from which they differ

// Places and normals a coordinate a column, single precision being enough beside the data's centre.
struct Facets {
  Eigen::ArrayX3f places, normals;
};

Facets facets_of(const Eigen::Matrix3Xd& places, const Eigen::Matrix3Xd& normals, const Vec3& origin) {
  return {(places.colwise() - origin).transpose().cast<float>(), normals.transpose().cast<float>()};
}

struct Skin {
  Eigen::Matrix3Xd places, normals;
  Vec3 centre = Vec3::Zero();
  Mat3 axes = Mat3::Identity();  // columns, longest first
  double radius = 0;             // root mean square distance from the centre
  Facets facets;                 // beside the centre
};

Skin skin_of(const Shape& shape) {
  const std::size_t count = std::min(samples, shape.surface.size());
  Skin skin;
  skin.places.resize(3, count);
  skin.normals.resize(3, count);
  for (std::size_t i = 0; i < count; ++i) {
    skin.places.col(i) = shape.surface[i].position;
    skin.normals.col(i) = shape.surface[i].normal;
  }
  skin.centre = skin.places.rowwise().mean();
  const Eigen::Matrix3Xd offsets = skin.places.colwise() - skin.centre;
  skin.radius = std::sqrt(offsets.squaredNorm() / static_cast<double>(count));
  skin.axes = Eigen::SelfAdjointEigenSolver<Mat3>(offsets * offsets.transpose()).eigenvectors().rowwise().reverse();
  skin.facets = facets_of(skin.places, skin.normals, skin.centre);
  return skin;
}

// All 24 ways to lay three axes on three axes with a determinant of the wanted sign.
std::vector<Mat3> axis_turns(double sign) {
  std::vector<Mat3> turns;
  int order[3] = {0, 1, 2};
  do {
    for (int flips = 0; flips < 8; ++flips) {
      Mat3 turn = Mat3::Zero();
      for (int a = 0; a < 3; ++a) turn(order[a], a) = (flips >> a & 1) ? -1 : 1;
      if (turn.determinant() * sign > 0) turns.push_back(turn);
    }
  } while (std::next_permutation(order, order + 3));
  return turns;
}

struct Settled {
  Similarity similarity;
  double distance = std::numeric_limits<double>::infinity();  // two-way mean, normals counted, in data diagonals
};

// For each of `from` the number of the nearest of `to`, places that face away being farther; adds up the distances.
double nearest_partners(const Facets& from, const Facets& to, double facing, std::vector<int>& partner) {
  const auto square = static_cast<float>(facing * facing);
  double sum = 0;
  partner.resize(static_cast<std::size_t>(from.places.rows()));
  Eigen::ArrayXf cost(to.places.rows());
  for (Eigen::Index i = 0; i < from.places.rows(); ++i) {
    const auto x = from.places.row(i), n = from.normals.row(i);
    cost = (to.places.col(0) - x[0]).square() + (to.places.col(1) - x[1]).square() + (to.places.col(2) - x[2]).square() +
           square * (1 - to.normals.col(0) * n[0] - to.normals.col(1) * n[1] - to.normals.col(2) * n[2]);
    sum += std::sqrt(std::max(0.0f, cost.minCoeff(&partner[static_cast<std::size_t>(i)])));
  }
  return sum / static_cast<double>(from.places.rows());
}

// Closest points both ways and the best similarity, in turn.
Settled settle(const Similarity& start, const Skin& model, const Skin& data, double diagonal, Chirality chirality) {
  Settled settled{start};
  std::vector<int> of_model, of_data;
  for (int step = 0; step <= settle_steps; ++step) {
    const Similarity& s = settled.similarity;
    const Eigen::Matrix3Xd mapped = (s.scale * (s.rotation * model.places)).colwise() + s.shift;
    const Facets here = facets_of(mapped, s.rotation * model.normals, data.centre);
    const double facing = 0.1 * diagonal;
    const double forth = nearest_partners(here, data.facets, facing, of_model), back = nearest_partners(data.facets, here, facing, of_data);
    settled.distance = 0.5 * (forth + back) / diagonal;
    if (step == settle_steps) break;
    std::vector<WeighedPair> pairs;
    for (std::size_t i = 0; i < of_model.size(); ++i) pairs.push_back({model.places.col(i), data.places.col(of_model[i]), 1});
    for (std::size_t k = 0; k < of_data.size(); ++k) pairs.push_back({model.places.col(of_data[k]), data.places.col(k), 1});
    settled.similarity = best_similarity(pairs, chirality);
  }
  return settled;
}

bool same_start(const Similarity& a, const Similarity& b, const Skin& model, double diagonal) {
  double sum = 0;
  for (Eigen::Index i = 0; i < model.places.cols(); ++i) sum += (a(model.places.col(i)) - b(model.places.col(i))).norm();
  return sum / static_cast<double>(model.places.cols()) < different * diagonal;
}

GrownSet set_of(const Similarity& similarity, Chirality chirality) {
  GrownSet set;
  set.chirality = chirality;
  set.spline.similarity = similarity;
  set.spline.affine.leftCols<3>() = similarity.scale * similarity.rotation;
  set.spline.affine.col(3) = similarity.shift;
  return set;
}

}  // namespace

std::vector<GrownSet> axis_starts(const Shape& model, const Shape& data, Chirality chirality, std::size_t most) {
  if (model.surface.empty() || data.surface.empty()) return {};
  const double sign = chirality == Chirality::proper ? 1 : -1;
  const Skin a = skin_of(model), b = skin_of(data);
  const double axes_sign = a.axes.determinant() * b.axes.determinant() * sign;
  const std::vector<Mat3> turns = axis_turns(axes_sign);
  std::vector<Settled> settled(turns.size());
  parallel_for(turns.size(), [&](std::size_t i) {
    Similarity start;
    start.scale = b.radius / a.radius;
    start.rotation = b.axes * turns[i] * a.axes.transpose();
    start.shift = b.centre - start.scale * (start.rotation * a.centre);
    settled[i] = settle(start, a, b, data.diagonal, chirality);
  });
  std::stable_sort(settled.begin(), settled.end(), [](const Settled& x, const Settled& y) { return x.distance < y.distance; });
  settled = distinct(std::move(settled), most,
                     [&](const Settled& x, const Settled& kept) { return same_start(x.similarity, kept.similarity, a, data.diagonal); });
  std::vector<GrownSet> starts;
  for (const Settled& s : settled) starts.push_back(set_of(s.similarity, chirality));
  return starts;
}

}  // namespace homolog
