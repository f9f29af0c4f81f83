// SPDX-License-Identifier: MIT
#include "homolog/match/elastic_skin.h"

#include <Eigen/IterativeLinearSolvers>
#include <algorithm>
#include <cmath>

#include "homolog/base/parallel.h"
#include "homolog/shape/weld.h"

namespace homolog {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr double most_cotangent = 20;  // of an angle of 3 degrees; slivers would outweigh all else
constexpr double least_weight = 1e-4;  // with which a vertex that nothing draws stays, so that the system has one solution
constexpr double tolerance = 1e-3;     // of the forces
constexpr int most_steps = 200;

/// Half the cotangent of the angle at corner k, which weighs the edge on the other side; never negative.
double edge_weight(const Mesh& mesh, const Triangle& triangle, int k) {
  const Vec3& corner = mesh.vertices[triangle[k]];
  const Vec3 a = mesh.vertices[triangle[(k + 1) % 3]] - corner, b = mesh.vertices[triangle[(k + 2) % 3]] - corner;
  const double sine = a.cross(b).norm(), cosine = a.dot(b);
  return cosine <= 0 ? 0 : cosine >= most_cotangent * sine ? most_cotangent / 2 : cosine / sine / 2;
}

}  // namespace

ElasticSkin::ElasticSkin(const Mesh& rest, double scale, Chirality chirality)
    : rest_(rest.vertices), scale_(scale), chirality_(chirality), first_(first_equal_vertex(rest.vertices)) {
  const auto count = static_cast<int>(rest.vertices.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < count; ++i) entries.emplace_back(i, i, 0.0);  // a vertex without triangles has its place on the diagonal, too
  areas_ = Eigen::VectorXd::Zero(count);
  for (const auto& triangle : rest.triangles) {
    const Vec3 &a = rest.vertices[triangle[0]], &b = rest.vertices[triangle[1]], &c = rest.vertices[triangle[2]];
    const double third = scale * scale * (b - a).cross(c - a).norm() / 6;
    for (int k = 0; k < 3; ++k) {
      areas_[first_[triangle[k]]] += third;
      const auto i = static_cast<int>(first_[triangle[(k + 1) % 3]]), j = static_cast<int>(first_[triangle[(k + 2) % 3]]);
      const double weight = i == j ? 0 : edge_weight(rest, triangle, k);
      entries.insert(entries.end(), {{i, i, weight}, {j, j, weight}, {i, j, -weight}, {j, i, -weight}});
    }
  }
  stiffness_.resize(count, count);
  stiffness_.setFromTriplets(entries.begin(), entries.end());
  areas_ = areas_.cwiseMax(1e-9 * areas_.sum());
}

std::vector<Mat3> ElasticSkin::local_similarities(const std::vector<Vec3>& positions) const {
  std::vector<Mat3> similarities(rest_.size());
  parallel_for(rest_.size(), [&](std::size_t i) {
    Mat3 covariance = Mat3::Zero();
    double square = 0;
    for (Sparse::InnerIterator edge(stiffness_, static_cast<Eigen::Index>(i)); edge; ++edge) {
      const Vec3 at_rest = rest_[i] - rest_[edge.row()];  // zero on the diagonal
      covariance -= edge.value() * (positions[i] - positions[edge.row()]) * at_rest.transpose();
      square -= edge.value() * at_rest.squaredNorm();
    }
    const Turn turn = nearest_turn(covariance, chirality_);
    const double own = square > 0 ? std::max(turn.trace / square, 0.0) : scale_;
    similarities[i] = std::sqrt(own * scale_) * turn.rotation;
  });
  return similarities;
}

Eigen::MatrixX3d ElasticSkin::forces(const std::vector<Vec3>& positions, const VertexPull& pull, double length) const {
  const std::vector<Mat3> local = local_similarities(positions);
  Eigen::MatrixX3d forces = Eigen::MatrixX3d::Zero(areas_.size(), 3);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Eigen::Index first = first_[i];
    forces.row(first) += pull.weights[i] * areas_[first] * (pull.targets[i] - positions[i]).transpose();
    for (Sparse::InnerIterator edge(stiffness_, static_cast<Eigen::Index>(i)); edge; ++edge) {
      const Mat3 mean = (local[i] + local[edge.row()]) / 2;
      const Vec3 wanted = mean * (rest_[i] - rest_[edge.row()]), is = positions[i] - positions[edge.row()];
      forces.row(static_cast<Eigen::Index>(i)) -= length * length * edge.value() * (wanted - is).transpose();
    }
  }
  return forces;
}

std::vector<Vec3> ElasticSkin::drawn(const std::vector<Vec3>& positions, const VertexPull& pull, double length) const {
  Eigen::VectorXd weights = least_weight * areas_;
  for (std::size_t i = 0; i < positions.size(); ++i) weights[first_[i]] += pull.weights[i] * areas_[first_[i]];
  Sparse system = length * length * stiffness_;
  system.diagonal() += weights;
  Eigen::ConjugateGradient<Sparse, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(tolerance);
  solver.setMaxIterations(most_steps);
  solver.compute(system);
  const Eigen::MatrixX3d shifts = solver.solve(forces(positions, pull, length));
  std::vector<Vec3> result(positions.size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = positions[i] + shifts.row(first_[i]).transpose();
  return result;
}

}  // namespace homolog
