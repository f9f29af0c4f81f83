// SPDX-License-Identifier: MIT
#include "homolog/match/axis_starts.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "homolog/base/distinct.h"
#include "homolog/base/parallel.h"
#include "homolog/describe/separate_surfaces.h"
#include "homolog/match/best_similarity.h"

namespace homolog {
namespace {

constexpr std::size_t samples = 150;  // of each skin
constexpr int settle_steps = 12;
constexpr double different = 0.15;       // mean distance of two starts, in data diagonals, from which they differ
constexpr std::size_t most_pieces = 12;  // of the data, that are tried apart

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
  double diagonal = 0;           // of the box around them
  Facets facets;                 // beside the centre
};

Skin skin_of(const std::vector<SurfaceSample>& surface, double diagonal) {
  const std::size_t count = std::min(samples, surface.size());
  Skin skin;
  skin.diagonal = diagonal;
  skin.places.resize(3, count);
  skin.normals.resize(3, count);
  for (std::size_t i = 0; i < count; ++i) {
    skin.places.col(i) = surface[i].position;
    skin.normals.col(i) = surface[i].normal;
  }
  skin.centre = skin.places.rowwise().mean();
  const Eigen::Matrix3Xd offsets = skin.places.colwise() - skin.centre;
  skin.radius = std::sqrt(offsets.squaredNorm() / static_cast<double>(count));
  skin.axes = Eigen::SelfAdjointEigenSolver<Mat3>(offsets * offsets.transpose()).eigenvectors().rowwise().reverse();
  skin.facets = facets_of(skin.places, skin.normals, skin.centre);
  return skin;
}

double diagonal_of(const std::vector<SurfaceSample>& surface) {
  Eigen::AlignedBox3d box;
  for (const SurfaceSample& s : surface) box.extend(s.position);
  return box.diagonal().norm();
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
  std::vector<float> costs(static_cast<std::size_t>(to.places.rows()));
  Eigen::Map<Eigen::ArrayXf> cost(costs.data(), to.places.rows());  // of an Array, which could be resized, g++ 12 warns falsely
  for (Eigen::Index i = 0; i < from.places.rows(); ++i) {
    const auto x = from.places.row(i), n = from.normals.row(i);
    cost = (to.places.col(0) - x[0]).square() + (to.places.col(1) - x[1]).square() + (to.places.col(2) - x[2]).square() +
           square * (1 - to.normals.col(0) * n[0] - to.normals.col(1) * n[1] - to.normals.col(2) * n[2]);
    sum += std::sqrt(std::max(0.0f, cost.minCoeff(&partner[static_cast<std::size_t>(i)])));
  }
  return sum / static_cast<double>(from.places.rows());
}

// Closest points both ways and the best similarity, in turn.
Settled settle(const Similarity& start, const Skin& model, const Skin& data, Chirality chirality) {
  Settled settled{start};
  std::vector<int> of_model, of_data;
  for (int step = 0; step <= settle_steps; ++step) {
    const Similarity& s = settled.similarity;
    const Eigen::Matrix3Xd mapped = (s.scale * (s.rotation * model.places)).colwise() + s.shift;
    const Facets here = facets_of(mapped, s.rotation * model.normals, data.centre);
    const double facing = 0.1 * data.diagonal;
    const double forth = nearest_partners(here, data.facets, facing, of_model), back = nearest_partners(data.facets, here, facing, of_data);
    settled.distance = 0.5 * (forth + back) / data.diagonal;
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

// The best few ways to lay the one on the other, settled.
std::vector<Settled> ways_to_lay(const Skin& model, const Skin& data, Chirality chirality, std::size_t most) {
  const double sign = chirality == Chirality::proper ? 1 : -1;
  const std::vector<Mat3> turns = axis_turns(model.axes.determinant() * data.axes.determinant() * sign);
  std::vector<Settled> settled(turns.size());
  parallel_for(turns.size(), [&](std::size_t i) {
    Similarity start;
    start.scale = data.radius / model.radius;
    start.rotation = data.axes * turns[i] * model.axes.transpose();
    start.shift = data.centre - start.scale * (start.rotation * model.centre);
    settled[i] = settle(start, model, data, chirality);
  });
  std::stable_sort(settled.begin(), settled.end(), [](const Settled& x, const Settled& y) { return x.distance < y.distance; });
  return distinct(std::move(settled), most,
                  [&](const Settled& x, const Settled& kept) { return same_start(x.similarity, kept.similarity, model, data.diagonal); });
}

}  // namespace

std::vector<GrownSet> axis_starts(const Shape& model, const Shape& data, Chirality chirality, std::size_t most) {
  if (model.surface.empty() || data.surface.empty()) return {};
  std::vector<Skin> skins{skin_of(data.surface, data.diagonal)};
  for (const auto& surface : separate_surfaces(data.surface, data.body, most_pieces))
    skins.push_back(skin_of(surface, diagonal_of(surface)));
  const Skin laid = skin_of(model.surface, model.diagonal);
  std::vector<GrownSet> starts;
  for (const Skin& skin : skins) {
    for (const Settled& s : ways_to_lay(laid, skin, chirality, most)) starts.push_back(set_of(s.similarity, chirality));
  }
  return starts;
}

}  // namespace homolog
