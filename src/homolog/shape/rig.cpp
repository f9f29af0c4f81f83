// SPDX-License-Identifier: MIT
#include "homolog/shape/rig.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>

namespace homolog {

Mat4 local_bind(const Rig& rig, std::size_t joint) {
  const auto& [name, parent, bind] = rig.joints[joint];
  return parent < 0 ? bind : Mat4(rig.joints[static_cast<std::size_t>(parent)].bind.inverse() * bind);
}

Influences strongest_influences(std::vector<Influence> influences, std::size_t most) {
  std::stable_sort(influences.begin(), influences.end(), [](const Influence& a, const Influence& b) { return a.joint < b.joint; });
  std::vector<Influence> joined;
  for (const Influence& influence : influences) {
    if (!(influence.weight > 0)) continue;
    if (joined.empty() || joined.back().joint != influence.joint) joined.push_back({influence.joint, 0});
    joined.back().weight += influence.weight;
  }
  std::stable_sort(joined.begin(), joined.end(), [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
  joined.resize(std::min({joined.size(), most, Influences{}.size()}));
  float sum = 0;
  for (const Influence& influence : joined) sum += influence.weight;
  Influences strongest{};
  for (std::size_t i = 0; i < joined.size(); ++i) strongest[i] = {joined[i].joint, joined[i].weight / sum};
  return strongest;
}

std::size_t most_influences(const std::vector<Influences>& influences) {
  for (const Influences& of_vertex : influences) {
    if (of_vertex[few_influences].weight > 0) return of_vertex.size();
  }
  return few_influences;
}

Mat4 matrix_of(const Pose& pose) {
  Mat4 matrix = Mat4::Identity();
  matrix.topLeftCorner<3, 3>() = pose.turn.toRotationMatrix() * pose.scale.asDiagonal();
  matrix.topRightCorner<3, 1>() = pose.shift;
  return matrix;
}

Pose pose_of(const Mat4& matrix) {
  Pose pose;
  pose.shift = matrix.topRightCorner<3, 1>();
  Mat3 axes = matrix.topLeftCorner<3, 3>();
  pose.scale = axes.colwise().norm();
  if (axes.determinant() < 0) pose.scale.x() = -pose.scale.x();
  for (Eigen::Index i = 0; i < 3; ++i) axes.col(i) = pose.scale[i] == 0 ? Vec3(Vec3::Unit(i)) : Vec3(axes.col(i) / pose.scale[i]);
  const Eigen::JacobiSVD<Mat3> svd(axes, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 turn = svd.matrixU() * svd.matrixV().transpose();
  if (turn.determinant() < 0) turn = svd.matrixU() * Vec3(1, 1, -1).asDiagonal() * svd.matrixV().transpose();
  pose.turn = Eigen::Quaterniond(turn).normalized();
  return pose;
}

}  // namespace homolog
