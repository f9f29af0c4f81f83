// SPDX-License-Identifier: MIT
// Sec. 6.1. The similarity-free spline needs only constants projected out of the kernel -r; its energy is quadratic in the targets and
// its best similarity has a closed form (one SVD), see docs/paper_map.md.
#include "homolog/match/thin_plate_spline.h"

#include <Eigen/Dense>
#include <limits>
#include <stdexcept>

namespace homolog {
namespace {

// Points as rows about their mean: far from the origin the differences would drown in rounding.
struct Centred {
  Eigen::MatrixX3d rows;
  Vec3 mean;
};

Centred centred(const std::vector<Vec3>& points) {
  Centred result{Eigen::MatrixX3d(points.size(), 3), Vec3::Zero()};
  for (const Vec3& point : points) result.mean += point / static_cast<double>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) result.rows.row(i) = points[i] - result.mean;
  return result;
}

Eigen::MatrixXd kernel_matrix(const std::vector<Vec3>& points, Kernel kernel) {
  const Eigen::Index n = points.size();
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) K(i, j) = K(j, i) = phi(kernel, (points[i] - points[j]).norm());
  }
  return K;
}

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

void store_weights(ThinPlateSpline& spline, const std::vector<Vec3>& sources, const Eigen::MatrixX3d& W) {
  spline.centres = sources;
  for (Eigen::Index i = 0; i < W.rows(); ++i) spline.weights.push_back(W.row(i));
}

}  // namespace

double phi(Kernel kernel, double distance) { return kernel == Kernel::r ? distance : distance * distance * distance; }

Mat4 Similarity::matrix() const {
  Mat4 matrix = Mat4::Identity();
  matrix.topLeftCorner<3, 3>() = scale * rotation;
  matrix.topRightCorner<3, 1>() = shift;
  return matrix;
}

Turn nearest_turn(const Mat3& covariance, Chirality chirality) {
  const Eigen::JacobiSVD<Mat3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vec3 D(1, 1, 1);
  const double wanted = chirality == Chirality::proper ? 1 : -1;
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() * wanted < 0) D.z() = -1;
  return {svd.matrixU() * D.asDiagonal() * svd.matrixV().transpose(), svd.singularValues().dot(D)};
}

ThinPlateSpline ThinPlateSpline::affine_free(const std::vector<Vec3>& sources, const std::vector<Vec3>& targets) {
  require(sources.size() == targets.size() && sources.size() >= 4, "an affine-free spline needs at least four pairs");
  const Eigen::Index n = sources.size();
  ThinPlateSpline spline;
  spline.kernel = Kernel::r3;
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(n + 4, n + 4);  // Sec. 6.1: [K P; P' 0]
  L.topLeftCorner(n, n) = kernel_matrix(sources, Kernel::r3);
  L.col(n).head(n).setOnes();
  const Centred X = centred(sources), Y = centred(targets);
  L.block(0, n + 1, n, 3) = X.rows;
  L.bottomLeftCorner(4, n) = L.topRightCorner(n, 4).transpose();
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(n + 4, 3);
  right.topRows(n) = Y.rows;
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(L);
  if (!lu.isInvertible()) {
    spline.energy = std::numeric_limits<double>::infinity();
    return spline;
  }
  const Eigen::MatrixX3d solution = lu.solve(right);
  const Eigen::MatrixX3d W = solution.topRows(n);
  store_weights(spline, sources, W);
  spline.affine.leftCols<3>() = solution.bottomRows<3>().transpose();
  spline.affine.col(3) = solution.row(n).transpose() + Y.mean - spline.affine.leftCols<3>() * X.mean;
  spline.energy = std::max(0.0, (W.transpose() * L.topLeftCorner(n, n) * W).trace());  // trace[W'KW], Delta of eq. 8
  return spline;
}

SourceSystem::SourceSystem(std::vector<Vec3> sources, const std::vector<double>& nugget) : sources_(std::move(sources)) {
  require(sources_.size() == nugget.size() && sources_.size() >= 2, "a similarity-free spline needs at least two sources");
  const Eigen::Index n = sources_.size();
  Eigen::MatrixXd bordered = Eigen::MatrixXd::Ones(n + 1, n + 1);
  bordered.topLeftCorner(n, n) = -kernel_matrix(sources_, Kernel::r);
  bordered.topLeftCorner(n, n).diagonal() += Eigen::Map<const Eigen::VectorXd>(nugget.data(), n);
  bordered(n, n) = 0;
  lu_.compute(bordered);
}

Eigen::MatrixX3d SourceSystem::solve(const Eigen::MatrixX3d& values) const {
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(values.rows() + 1, 3);
  right.topRows(values.rows()) = values;
  return lu_.solve(right);
}

double SourceSystem::variance(const Vec3& x) const {
  const Eigen::Index n = sources_.size();
  Eigen::VectorXd k = Eigen::VectorXd::Ones(n + 1);
  for (Eigen::Index i = 0; i < n; ++i) k[i] = -(x - sources_[i]).norm();
  return std::max(0.0, -k.dot(lu_.solve(k)));
}

ThinPlateSpline ThinPlateSpline::similarity_free(const SourceSystem& system, const std::vector<Vec3>& targets, Chirality chirality) {
  const Eigen::Index n = system.sources().size();
  require(targets.size() == system.sources().size(), "a spline needs as many targets as sources");
  const Centred X = centred(system.sources()), Y = centred(targets);
  const Eigen::MatrixX3d MX = system.solve(X.rows).topRows(n), MY = system.solve(Y.rows).topRows(n);  // M: constants are projected out
  const Turn turn = nearest_turn(Y.rows.transpose() * MX, chirality);
  const double spread = (X.rows.transpose() * MX).trace();

  ThinPlateSpline spline;
  spline.similarity.rotation = turn.rotation;
  spline.similarity.scale = turn.trace / spread;
  const Mat3 A = spline.similarity.scale * spline.similarity.rotation;
  const Eigen::MatrixX3d solution = system.solve(Y.rows - X.rows * A.transpose());
  store_weights(spline, system.sources(), -solution.topRows(n));  // -phi is the positive kernel
  spline.similarity.shift = solution.row(n).transpose() + Y.mean - A * X.mean;
  spline.affine.leftCols<3>() = A;
  spline.affine.col(3) = spline.similarity.shift;
  spline.energy = std::max(0.0, (Y.rows.transpose() * MY).trace() - turn.trace * turn.trace / spread);
  return spline;
}

Vec3 ThinPlateSpline::operator()(const Vec3& x) const {
  Vec3 y = affine.leftCols<3>() * x + affine.col(3);  // Sec. 6.1: f(x)
  for (std::size_t k = 0; k < centres.size(); ++k) y += weights[k] * phi(kernel, (x - centres[k]).norm());
  return y;
}

}  // namespace homolog
