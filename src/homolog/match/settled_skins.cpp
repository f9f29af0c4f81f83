// SPDX-License-Identifier: MIT
#include "homolog/match/settled_skins.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "homolog/base/distinct.h"
#include "homolog/base/parallel.h"
#include "homolog/match/best_similarity.h"

namespace homolog {
namespace {

constexpr std::size_t samples = 150;
constexpr Eigen::Index rough_samples = 60;
constexpr int settle_steps = 12;
constexpr double different = 0.15;  // mean distance of two starts, in diagonals of the data, from which they differ
constexpr double facing = 0.1;      // diagonals of the data that a normal turned away counts

Facets facets_of(const Eigen::Matrix3Xd& places, const Eigen::Matrix3Xd& normals, const Vec3& origin) {
  return {(places.colwise() - origin).transpose().cast<float>(), normals.transpose().cast<float>()};
}

// The first samples; all, if there are not so many.
Facets first_of(const Facets& facets, Eigen::Index count) {
  const Eigen::Index taken = std::min(count, facets.places.rows());
  return {facets.places.topRows(taken), facets.normals.topRows(taken)};
}

Facets laid(const Similarity& s, const AxisSkin& model, const AxisSkin& data) {
  const Eigen::Matrix3Xd mapped = (s.scale * (s.rotation * model.places)).colwise() + s.shift;
  return facets_of(mapped, s.rotation * model.normals, data.centre);
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

// The mean of both ways, in diagonals of the data.
double two_way_distance(const Partners& partners, double diagonal) {
  return 0.5 * (partners.model_distance + partners.data_distance) / diagonal;
}

}  // namespace

AxisSkin axis_skin(const std::vector<SurfaceSample>& surface, double diagonal) {
  const std::size_t count = std::min(samples, surface.size());
  AxisSkin skin;
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

std::vector<Similarity> axis_similarities(const AxisSkin& model, const AxisSkin& data, Chirality chirality) {
  const double sign = chirality == Chirality::proper ? 1 : -1;
  std::vector<Similarity> all;
  for (const Mat3& turn : axis_turns(model.axes.determinant() * data.axes.determinant() * sign)) {
    Similarity& s = all.emplace_back();
    s.scale = data.radius / model.radius;
    s.rotation = data.axes * turn * model.axes.transpose();
    s.shift = data.centre - s.scale * (s.rotation * model.centre);
  }
  return all;
}

Settled settle(const Similarity& start, const AxisSkin& model, const AxisSkin& data, Chirality chirality) {
  Settled settled{start};
  for (int step = 0; step <= settle_steps; ++step) {
    const Partners partners = nearest_partners(laid(settled.similarity, model, data), data.facets, facing * data.diagonal);
    settled.distance = two_way_distance(partners, data.diagonal);
    if (step == settle_steps) break;
    std::vector<WeighedPair> pairs;
    for (std::size_t i = 0; i < partners.of_model.size(); ++i) {
      pairs.push_back({model.places.col(i), data.places.col(partners.of_model[i]), 1});
    }
    for (std::size_t k = 0; k < partners.of_data.size(); ++k) {
      pairs.push_back({model.places.col(partners.of_data[k]), data.places.col(k), 1});
    }
    settled.similarity = best_similarity(pairs, chirality);
  }
  return settled;
}

bool same_start(const Similarity& a, const Similarity& b, const AxisSkin& model, double diagonal) {
  double sum = 0;
  for (Eigen::Index i = 0; i < model.places.cols(); ++i) sum += (a(model.places.col(i)) - b(model.places.col(i))).norm();
  return sum / static_cast<double>(model.places.cols()) < different * diagonal;
}

std::vector<Settled> ways_to_lay(const AxisSkin& model, const AxisSkin& data, Chirality chirality, std::size_t most) {
  const std::vector<Similarity> similarities = axis_similarities(model, data, chirality);
  std::vector<Settled> settled(similarities.size());
  parallel_for(similarities.size(), [&](std::size_t i) { settled[i] = settle(similarities[i], model, data, chirality); });
  std::stable_sort(settled.begin(), settled.end(), [](const Settled& x, const Settled& y) { return x.distance < y.distance; });
  return distinct(std::move(settled), most,
                  [&](const Settled& x, const Settled& kept) { return same_start(x.similarity, kept.similarity, model, data.diagonal); });
}

Settled rough_look(const Similarity& start, const AxisSkin& model, const AxisSkin& data) {
  const Facets here = first_of(laid(start, model, data), rough_samples), there = first_of(data.facets, rough_samples);
  return {start, two_way_distance(nearest_partners(here, there, facing * data.diagonal), data.diagonal)};
}

GrownSet set_of(const Similarity& similarity, Chirality chirality) {
  GrownSet set;
  set.chirality = chirality;
  set.spline.similarity = similarity;
  set.spline.affine.leftCols<3>() = similarity.scale * similarity.rotation;
  set.spline.affine.col(3) = similarity.shift;
  return set;
}

}  // namespace homolog
