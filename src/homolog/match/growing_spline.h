// SPDX-License-Identifier: MIT
// Sec. 6.1: the similarity-free spline of a set that grows pair by pair (thin_plate_spline.h), asked only at places known beforehand.
// The same numbers without solving anew: the kernel -r is the covariance of a random function that each pair tells more of, so that a pair
// is one more column of a Cholesky factor (kriging, which is Gaussian process regression). m places and n pairs cost O(m n) a pair.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "homolog/match/thin_plate_spline.h"

namespace homolog {

class GrowingSpline {
 public:
  /// `places` in model space; everything else names them by their numbers.
  GrowingSpline(const std::vector<Vec3>& places, Chirality chirality);

  /// The spline shall take the place to `target`, which it may miss by as much as `nugget` > 0 says (units of length, SourceSystem).
  void add(Eigen::Index place, const Vec3& target, double nugget);

  /// Scale and rotation of the similarity that is free of cost, without its shift; needs pairs of two places.
  Similarity free_part() const;
  /// f(place), given free_part().
  Vec3 at(Eigen::Index place, const Similarity& free_part) const;
  /// Variance of that prediction in units of length (SourceSystem::variance); needs one pair.
  double variance(Eigen::Index place) const { return variance_[place]; }

 private:
  void add_first(Eigen::Index place, const Vec3& target, double nugget);
  Eigen::VectorXd distances_from(Eigen::Index place) const;

  Chirality chirality_;
  Eigen::MatrixX3d places_;
  Eigen::VectorXd from_first_;  // |x - x_1| + nugget_1 / 2
  Eigen::MatrixXd factor_;      // m x (n - 1) of it in use: how each later pair covaries with the places
  Eigen::Index columns_ = 0;
  Eigen::VectorXd variance_;
  Eigen::MatrixX3d model_, data_;  // what the kernel alone makes of the sources' and the targets' coordinates at the places
  double spread_ = 0;              // of the sources, and covariance of targets with sources: both under the inverse kernel
  Mat3 covariance_ = Mat3::Zero();
};

}  // namespace homolog
