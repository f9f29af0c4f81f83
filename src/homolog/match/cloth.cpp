// SPDX-License-Identifier: MIT
#include "homolog/match/cloth.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>

namespace homolog {
namespace {

constexpr double anchor_weight = 2;
constexpr float outlier_share = 0.1f;  // of the expected sum of weights: what has no partner is not drawn anywhere
constexpr int shape_steps = 2;         // rotations and places in turn, per assignment

// Turns `rotation` to the one nearest to `covariance`, starting where it stands (Mueller et al. 2016); its determinant stays as it is.
void turn_towards(const Mat3& covariance, Mat3& rotation) {
  for (int step = 0; step < 12; ++step) {
    Vec3 turn = Vec3::Zero();
    double grip = 1e-300;
    for (int a = 0; a < 3; ++a) {
      turn += rotation.col(a).cross(covariance.col(a));
      grip += rotation.col(a).dot(covariance.col(a));
    }
    turn /= std::abs(grip);
    const double angle = turn.norm();
    if (!(angle > 1e-5)) return;
    rotation = Eigen::AngleAxisd(angle, turn / angle) * rotation;
  }
}

// Best local rotations, and local scales half way between the measured one and the cloth's.
void fit_local_frames(Cloth& cloth, const Body& model) {
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    Mat3 covariance = Mat3::Zero();
    double before = 0, after = 0;
    for (int j : model.neighbours[i]) {
      const Vec3 edge = model.nodes[j] - model.nodes[i], image = cloth.nodes[j] - cloth.nodes[i];
      covariance += image * edge.transpose();
      before += edge.squaredNorm();
      after += image.squaredNorm();
    }
    if (before == 0) continue;
    turn_towards(covariance, cloth.rotations[i]);
    const double measured = std::clamp(std::sqrt(after / before), 0.25 * cloth.scale, 4 * cloth.scale);
    cloth.scales[i] = std::sqrt(measured * cloth.scale);
  }
}

// The data's skin as rows, relative to a middle so that single precision suffices.
struct Samples {
  Eigen::MatrixX3f places, normals;
  Vec3 middle = Vec3::Zero();
};

Samples rows_of(const std::vector<SurfaceSample>& data) {
  Samples rows{Eigen::MatrixX3f(data.size(), 3), Eigen::MatrixX3f(data.size(), 3)};
  for (const SurfaceSample& s : data) rows.middle += s.position / static_cast<double>(data.size());
  for (std::size_t k = 0; k < data.size(); ++k) {
    rows.places.row(k) = (data[k].position - rows.middle).cast<float>();
    rows.normals.row(k) = data[k].normal.cast<float>();
  }
  return rows;
}

// What the data's samples ask of every skin node: a place, and how strongly.
struct Pull {
  std::vector<Vec3> place;
  std::vector<double> mass;
};

// One row of weights: near and facing the same way.
Eigen::ArrayXf weights_of(const Eigen::Vector3f& y, const Eigen::Vector3f& n, const Samples& data, float inverse) {
  const Eigen::ArrayXf square = inverse * (data.places.rowwise() - y.transpose()).rowwise().squaredNorm().array();
  const Eigen::ArrayXf agreement = (data.normals * n).array().max(0.0f);
  return (square < 12).select((-square).exp() * agreement.square(), 0.0f);
}

Pull assign(const Cloth& cloth, const Body& model, const Samples& data, double reach) {
  const Eigen::Index rows = model.surface_count, columns = data.places.rows();
  Eigen::MatrixXf weight(columns, rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Eigen::Vector3f normal = (cloth.rotations[i] * model.normals[i]).cast<float>();
    weight.col(i) = weights_of((cloth.nodes[i] - data.middle).cast<float>(), normal, data, static_cast<float>(0.5 / (reach * reach)));
  }
  const Eigen::ArrayXf row_sums = weight.colwise().sum().transpose(), column_sums = weight.rowwise().sum();
  const Eigen::ArrayXf by_row = 0.5f / (row_sums + outlier_share * row_sums.mean() + 1e-12f);
  const Eigen::ArrayXf by_column = 0.5f / (column_sums + outlier_share * column_sums.mean() + 1e-12f);
  Eigen::MatrixX4f place_and_one(columns, 4);
  place_and_one << data.places, Eigen::VectorXf::Ones(columns);
  const Eigen::MatrixX4f sums = by_row.matrix().asDiagonal() * (weight.transpose() * place_and_one) +
                                weight.transpose() * (by_column.matrix().asDiagonal() * place_and_one);
  Pull pull{std::vector<Vec3>(rows, Vec3::Zero()), std::vector<double>(rows, 0)};
  for (Eigen::Index i = 0; i < rows; ++i) {
    pull.mass[i] = sums(i, 3);
    if (sums(i, 3) > 1e-9f) pull.place[i] = data.middle + (sums.row(i).head<3>() / sums(i, 3)).cast<double>().transpose();
  }
  return pull;
}

using Sparse = Eigen::SparseMatrix<double>;

// lambda * Laplacian + masses + anchors.
Sparse system_matrix(const Body& model, const Pull& pull, const std::vector<Anchor>& anchors, double stiffness) {
  const int n = static_cast<int>(model.nodes.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    double diagonal = 1e-9 + stiffness * static_cast<double>(model.neighbours[i].size());
    if (i < static_cast<int>(pull.mass.size())) diagonal += pull.mass[i];
    entries.emplace_back(i, i, diagonal);
    for (int j : model.neighbours[i]) entries.emplace_back(i, j, -stiffness);
  }
  for (const Anchor& anchor : anchors) entries.emplace_back(anchor.node, anchor.node, anchor_weight);
  Sparse matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::MatrixX3d right_side(const Cloth& cloth, const Body& model, const Pull& pull, const std::vector<Anchor>& anchors, double stiffness) {
  Eigen::MatrixX3d right(model.nodes.size(), 3);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    Vec3 sum = 1e-9 * cloth.nodes[i];
    for (int j : model.neighbours[i]) {
      const Mat3 frame = 0.5 * (cloth.scales[i] * cloth.rotations[i] + cloth.scales[j] * cloth.rotations[j]);
      sum += stiffness * (frame * (model.nodes[i] - model.nodes[j]));
    }
    if (i < pull.mass.size()) sum += pull.mass[i] * pull.place[i];
    right.row(i) = sum;
  }
  for (const Anchor& anchor : anchors) right.row(anchor.node) += anchor_weight * anchor.place;
  return right;
}

}  // namespace

Cloth lay_cloth(const Body& model, const ThinPlateSpline& data_from_model, Chirality chirality) {
  Cloth cloth;
  cloth.chirality = chirality;
  cloth.scale = data_from_model.similarity.scale;
  for (const Vec3& node : model.nodes) cloth.nodes.push_back(data_from_model(node));
  cloth.rotations.assign(model.nodes.size(), data_from_model.similarity.rotation);
  cloth.scales.assign(model.nodes.size(), cloth.scale);
  fit_local_frames(cloth, model);
  return cloth;
}

void draw_cloth(Cloth& cloth, const Body& model, const std::vector<SurfaceSample>& data, double data_diagonal,
                const std::vector<Anchor>& anchors, const ClothSchedule& schedule) {
  const Samples samples = rows_of(data);
  Eigen::SimplicialLDLT<Sparse> solver;
  for (int step = 0; step < schedule.iterations; ++step) {
    const double share = schedule.iterations == 1 ? 1 : static_cast<double>(step) / (schedule.iterations - 1);
    const double reach = data_diagonal * schedule.first_reach * std::pow(schedule.last_reach / schedule.first_reach, share);
    const double stiffness = schedule.first_stiffness * std::pow(schedule.last_stiffness / schedule.first_stiffness, share);
    const Pull pull = assign(cloth, model, samples, reach);
    const Sparse matrix = system_matrix(model, pull, anchors, stiffness);
    if (step == 0) solver.analyzePattern(matrix);
    solver.factorize(matrix);
    for (int inner = 0; inner < shape_steps; ++inner) {
      const Eigen::MatrixX3d places = solver.solve(right_side(cloth, model, pull, anchors, stiffness));
      for (std::size_t i = 0; i < cloth.nodes.size(); ++i) cloth.nodes[i] = places.row(i);
      fit_local_frames(cloth, model);
    }
  }
}

}  // namespace homolog
