// SPDX-License-Identifier: MIT
#include "homolog/match/growing_spline.h"

#include <algorithm>
#include <cmath>

namespace homolog {

GrowingSpline::GrowingSpline(const std::vector<Vec3>& places, Chirality chirality) : chirality_(chirality), places_(places.size(), 3) {
  for (std::size_t i = 0; i < places.size(); ++i) places_.row(i) = places[i];
}

Eigen::VectorXd GrowingSpline::distances_from(Eigen::Index place) const {
  return (places_.rowwise() - places_.row(place)).rowwise().norm();
}

// Constants are free of cost: the first pair tells the constant, and all else is told as the difference from it.
void GrowingSpline::add_first(Eigen::Index place, const Vec3& target, double nugget) {
  from_first_ = distances_from(place).array() + nugget / 2;
  variance_ = 2 * from_first_;
  model_ = places_.row(place).replicate(places_.rows(), 1);
  data_ = target.transpose().replicate(places_.rows(), 1);
}

void GrowingSpline::add(Eigen::Index place, const Vec3& target, double nugget) {
  if (variance_.size() == 0) return add_first(place, target, nugget);
  if (columns_ == factor_.cols()) factor_.conservativeResize(places_.rows(), 2 * columns_ + 8);
  const double deviation = std::sqrt(variance_[place] + nugget);
  auto column = factor_.col(columns_);
  column = from_first_.array() + from_first_[place];
  column -= distances_from(place);
  column.noalias() -= factor_.leftCols(columns_) * factor_.row(place).head(columns_).transpose();
  column /= deviation;
  ++columns_;
  const Vec3 x = (places_.row(place) - model_.row(place)) / deviation, y = (target.transpose() - data_.row(place)) / deviation;
  model_.noalias() += column * x.transpose();
  data_.noalias() += column * y.transpose();
  variance_ = (variance_ - column.cwiseAbs2()).cwiseMax(0);
  spread_ += x.squaredNorm();
  covariance_ += y * x.transpose();
}

Similarity GrowingSpline::free_part() const {
  const Turn turn = nearest_turn(covariance_, chirality_);
  return {turn.trace / spread_, turn.rotation, Vec3::Zero()};
}

Vec3 GrowingSpline::at(Eigen::Index place, const Similarity& free_part) const {
  return data_.row(place).transpose() + free_part((places_.row(place) - model_.row(place)).transpose());
}

}  // namespace homolog
