// SPDX-License-Identifier: MIT
// Sec. 6.2.2, see the header. L = [K P; P' 0] as in Sec. 6.1.
#include "homolog/match/energy_increment.h"

#include <Eigen/Dense>
#include <limits>

#include "homolog/match/thin_plate_spline.h"

namespace homolog {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Rows [phi(|z - x_1|) .. phi(|z - x_n|) 1 z'].
Eigen::MatrixXd kernel_rows(const std::vector<Vec3>& places, const std::vector<Vec3>& sources) {
  const Eigen::Index n = sources.size();
  Eigen::MatrixXd rows(places.size(), n + 4);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    for (Eigen::Index j = 0; j < n; ++j) rows(i, j) = phi(Kernel::r3, (places[i] - sources[j]).norm());
    rows(i, n) = 1;
    rows.block<1, 3>(i, n + 1) = places[i].transpose();
  }
  return rows;
}

Eigen::MatrixXd kernel_between(const std::vector<Vec3>& a, const std::vector<Vec3>& b) { return kernel_rows(a, b).leftCols(b.size()); }

// The inverse of a symmetric matrix that is positive definite but for coinciding sources.
SmallSquare inverse_or_empty(const SmallSquare& S) {
  const Eigen::LDLT<SmallSquare> ldlt(S);
  if (!(ldlt.vectorD().minCoeff() > 1e-12)) return {};  // at unit size: sources 1e-4 apart
  return ldlt.solve(SmallSquare::Identity(S.rows(), S.cols()));
}

}  // namespace

EnergyIncrement::EnergyIncrement(std::vector<Vec3> sources, const std::vector<Vec3>& targets) : sources_(std::move(sources)) {
  const Eigen::Index n = sources_.size();
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(n + 4, n + 4);
  L.topRows(n) = kernel_rows(sources_, sources_);
  L.bottomLeftCorner(4, n) = L.topRightCorner(n, 4).transpose();
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(n + 4, 3);
  for (Eigen::Index i = 0; i < n; ++i) right.row(i) = targets[i].transpose();
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(L);
  energy_ = infinity;
  if (!lu.isInvertible()) return;
  inverse_ = lu.inverse();
  solution_ = inverse_ * right;
  energy_ = std::max(0.0, (solution_.transpose() * right).trace());  // Delta of eq. 8: trace[W'V] = trace[W'KW], since P'W = 0
}

EnergyIncrement::Block EnergyIncrement::block(const std::vector<Vec3>& sources) const {
  Block block{sources, kernel_rows(sources, sources_), {}, {}, {}};
  block.solved = inverse_ * block.K.transpose();
  block.predicted = block.K * solution_;
  block.precision = inverse_or_empty(kernel_between(sources, sources) - block.K * block.solved);
  return block;
}

SmallSquare EnergyIncrement::joint_precision(const Block& a, const Block& b) const {
  const Eigen::Index n = a.sources.size(), m = b.sources.size();
  SmallSquare S(n + m, n + m);
  S.topLeftCorner(n, n) = kernel_between(a.sources, a.sources) - a.K * a.solved;
  S.bottomRightCorner(m, m) = kernel_between(b.sources, b.sources) - b.K * b.solved;
  S.topRightCorner(n, m) = kernel_between(a.sources, b.sources) - a.K * b.solved;
  S.bottomLeftCorner(m, n) = S.topRightCorner(n, m).transpose();
  return inverse_or_empty(S);
}

double increment(const SmallSquare& precision, const SmallRows& residual) {
  if (precision.size() == 0) return infinity;
  const SmallRows weighted = precision * residual;
  return weighted.cwiseProduct(residual).sum();
}

}  // namespace homolog
