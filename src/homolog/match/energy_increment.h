// SPDX-License-Identifier: MIT
// Sec. 6.2.2: Delta(Q + c) and Delta(Q + c_p + c_q) for many c, from one inverse for Q. Knows nothing of shapes.
// Differs: the paper solves a spline for each; adding points to an r^3 spline raises its energy by res' S^-1 res, where res is by how much
// the spline of Q misses the new targets and S the Schur complement of L, which depends on sources only.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "homolog/base/vec.h"

namespace homolog {

/// At most two sources a block, two blocks at a time: no heap in the loops over pairs of candidates.
using SmallSquare = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;
using SmallRows = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 4, 3>;

/// The paper's affine-free r^3 spline of a few points, ready to tell what more points would cost.
class EnergyIncrement {
 public:
  /// One or two new sources, and what the spline knows of them.
  struct Block {
    std::vector<Vec3> sources;
    Eigen::MatrixXd K, solved;  ///< rows of the kernel against Q, and L^-1 of them
    SmallRows predicted;        ///< f_Q(sources)
    SmallSquare precision;      ///< S^-1; empty when the sources coincide with others
  };

  /// Needs at least four points; energy() is infinite when they lie in a plane.
  EnergyIncrement(std::vector<Vec3> sources, const std::vector<Vec3>& targets);

  /// Delta(Q).
  double energy() const { return energy_; }
  Block block(const std::vector<Vec3>& sources) const;
  /// S^-1 of two blocks taken together; empty when sources coincide.
  SmallSquare joint_precision(const Block& a, const Block& b) const;

 private:
  std::vector<Vec3> sources_;
  Eigen::MatrixXd inverse_;    // L^-1
  Eigen::MatrixX3d solution_;  // rows of W, t and A'
  double energy_ = 0;
};

/// tr(res' S^-1 res); infinite for an empty S^-1.
double increment(const SmallSquare& precision, const SmallRows& residual);

}  // namespace homolog
