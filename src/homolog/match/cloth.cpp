// SPDX-License-Identifier: MIT
#include "homolog/match/cloth.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>

#include "homolog/match/soft_assignment.h"

namespace homolog {
namespace {

constexpr double anchor_weight = 2;
constexpr double flat_share = 0.05;  // of the squared edges: stretch across a flat neighbourhood is the cloth's scale
constexpr int shape_steps = 2;       // rotations and places in turn, per assignment

// The body's edges in one row, node after node.
struct Edges {
  std::vector<int> first, other;
  std::vector<Vec3> vector;    // from the node to the other one, at rest
  std::vector<double> square;  // sum of squared lengths, per node
  std::vector<Mat3> inverse;   // of the sum of outer squares, made regular
};

Edges edges_of(const Body& model) {
  Edges edges{{0}, {}, {}, std::vector<double>(model.nodes.size()), std::vector<Mat3>(model.nodes.size(), Mat3::Zero())};
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    Mat3 squares = Mat3::Zero();
    for (int j : model.neighbours[i]) {
      edges.other.push_back(j);
      edges.vector.push_back(model.nodes[j] - model.nodes[i]);
      edges.square[i] += edges.vector.back().squaredNorm();
      squares += edges.vector.back() * edges.vector.back().transpose();
    }
    if (edges.square[i] > 0) edges.inverse[i] = (squares + flat_share * edges.square[i] * Mat3::Identity()).inverse();
    edges.first.push_back(static_cast<int>(edges.other.size()));
  }
  return edges;
}

// Turns `rotation` to the one nearest to `covariance`, starting where it stands (Mueller et al. 2016); its determinant stays as it is.
void turn_towards(const Mat3& covariance, Mat3& rotation) {
  for (int step = 0; step < 12; ++step) {
    Vec3 turn = Vec3::Zero();
    double grip = 1e-300;
    for (int a = 0; a < 3; ++a) {
      turn += rotation.col(a).cross(covariance.col(a));
      grip += rotation.col(a).dot(covariance.col(a));
    }
    turn /= 2 * std::abs(grip);
    const double half_angle = turn.norm();
    if (!(half_angle < 1e100)) return;
    rotation = Eigen::Quaterniond(1, turn.x(), turn.y(), turn.z()).normalized().toRotationMatrix() * rotation;
    if (half_angle < 1e-3) return;  // what is left is its square
  }
}

// The mean of every node's and its neighbours'.
std::vector<Mat3> smoothed(const std::vector<Mat3>& values, const Edges& edges) {
  std::vector<Mat3> means = values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (int e = edges.first[i]; e < edges.first[i + 1]; ++e) means[i] += values[edges.other[e]];
    means[i] /= 1 + edges.first[i + 1] - edges.first[i];
  }
  return means;
}

// Best local rotations, and local scales and stretches half way between the measured ones and the cloth's scale: a limb may become
// longer without becoming thicker.
void fit_local_frames(Cloth& cloth, const Edges& edges) {
  std::vector<Mat3> stretch(cloth.nodes.size(), cloth.scale * Mat3::Identity());
  for (std::size_t i = 0; i < cloth.nodes.size(); ++i) {
    if (edges.square[i] == 0) continue;
    Mat3 covariance = Mat3::Zero();
    double after = 0;
    for (int e = edges.first[i]; e < edges.first[i + 1]; ++e) {
      const Vec3 image = cloth.nodes[edges.other[e]] - cloth.nodes[i];
      covariance += image * edges.vector[e].transpose();
      after += image.squaredNorm();
    }
    turn_towards(covariance, cloth.rotations[i]);
    const double measured = std::clamp(std::sqrt(after / edges.square[i]), 0.25 * cloth.scale, 4 * cloth.scale);
    cloth.scales[i] = std::sqrt(measured * cloth.scale);
    const Mat3 turned_back = cloth.rotations[i].transpose() * covariance;
    const Mat3 gradient = (turned_back + flat_share * edges.square[i] * cloth.scale * Mat3::Identity()) * edges.inverse[i];
    stretch[i] = 0.5 * cloth.scale * Mat3::Identity() + 0.25 * (gradient + gradient.transpose());
  }
  stretch = smoothed(stretch, edges);
  for (std::size_t i = 0; i < cloth.nodes.size(); ++i) cloth.frames[i] = cloth.rotations[i] * stretch[i];
}

// Soft assignment draws every skin inwards from its ends and edges, even one that lies where it should. What it would do to the skin laid
// on itself is given back, as in the Sinkhorn divergence (Feydy et al. 2019).
Pull unbiased_pull(const std::vector<SurfaceSample>& skin, const SampleBlocks& data, double reach) {
  Pull pull = assign_softly(skin, data, reach);
  const Pull own = assign_softly(skin, make_blocks(skin), reach);
  for (std::size_t i = 0; i < skin.size(); ++i) pull.places[i] += skin[i].position - own.places[i];
  return pull;
}

using Sparse = Eigen::SparseMatrix<double>;

Sparse laplacian_of(const Edges& edges) {
  const int n = static_cast<int>(edges.square.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, edges.first[i + 1] - edges.first[i]);
    for (int e = edges.first[i]; e < edges.first[i + 1]; ++e) entries.emplace_back(i, edges.other[e], -1);
  }
  Sparse matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Where every node is drawn, and how strongly: by the data's samples, by anchors, and a trace to where it is.
struct Draw {
  Eigen::VectorXd mass;
  Eigen::MatrixX3d moment;  // mass times place
};

Draw draw_of(const Cloth& cloth, const Pull& pull, const std::vector<Anchor>& anchors, double stiffness) {
  constexpr double trace = 1e-9;
  const auto n = static_cast<Eigen::Index>(cloth.nodes.size());
  Draw draw{Eigen::VectorXd::Constant(n, trace), Eigen::MatrixX3d(n, 3)};
  for (Eigen::Index i = 0; i < n; ++i) draw.moment.row(i) = trace * cloth.nodes[i];
  const auto add = [&](std::size_t node, double mass, const Vec3& place) {
    draw.mass[node] += mass / stiffness;
    draw.moment.row(node) += mass / stiffness * place;
  };
  for (std::size_t i = 0; i < pull.masses.size(); ++i) add(i, pull.masses[i], pull.places[i]);
  for (const Anchor& anchor : anchors) add(anchor.node, anchor_weight, anchor.place);
  return draw;
}

// Laplacian of the rest shape laid by the local frames, and the draw.
Eigen::MatrixX3d right_side(const Cloth& cloth, const Edges& edges, const Draw& draw) {
  Eigen::MatrixX3d right = draw.moment;
  for (std::size_t i = 0; i < cloth.nodes.size(); ++i) {
    Vec3 sum = Vec3::Zero();
    for (int e = edges.first[i]; e < edges.first[i + 1]; ++e) sum += (cloth.frames[i] + cloth.frames[edges.other[e]]) * edges.vector[e];
    right.row(i) -= 0.5 * sum;
  }
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
  cloth.frames.assign(model.nodes.size(), cloth.scale * data_from_model.similarity.rotation);
  fit_local_frames(cloth, edges_of(model));
  return cloth;
}

std::vector<SurfaceSample> mapped_skin(const Cloth& cloth, const Body& model) {
  std::vector<SurfaceSample> skin;
  for (std::size_t i = 0; i < model.surface_count; ++i) skin.push_back({cloth.nodes[i], cloth.rotations[i] * model.normals[i]});
  return skin;
}

void draw_cloth(Cloth& cloth, const Body& model, const std::vector<SurfaceSample>& data, double data_diagonal,
                const std::vector<Anchor>& anchors, const ClothSchedule& schedule) {
  const SampleBlocks samples = make_blocks(data);
  const Edges edges = edges_of(model);
  const Sparse laplacian = laplacian_of(edges);
  Sparse system = laplacian;
  Eigen::SimplicialLDLT<Sparse> solver;
  solver.analyzePattern(system);
  for (int step = 0; step < schedule.iterations; ++step) {
    const double share = schedule.iterations == 1 ? 1 : static_cast<double>(step) / (schedule.iterations - 1);
    const double reach = data_diagonal * schedule.first_reach * std::pow(schedule.last_reach / schedule.first_reach, share);
    const double stiffness = schedule.first_stiffness * std::pow(schedule.last_stiffness / schedule.first_stiffness, share);
    const Pull pull = unbiased_pull(mapped_skin(cloth, model), samples, reach);
    const Draw draw = draw_of(cloth, pull, anchors, stiffness);
    system.diagonal() = laplacian.diagonal() + draw.mass;
    solver.factorize(system);
    for (int inner = 0; inner < shape_steps; ++inner) {
      const Eigen::MatrixX3d places = solver.solve(right_side(cloth, edges, draw));
      for (std::size_t i = 0; i < cloth.nodes.size(); ++i) cloth.nodes[i] = places.row(i);
      fit_local_frames(cloth, edges);
    }
  }
}

}  // namespace homolog
