// SPDX-License-Identifier: MIT
#include "homolog/match/carry_animations.h"

#include <Eigen/LU>

#include "homolog/match/local_similarity.h"

namespace homolog {
namespace {

/// How the poses of one joint are carried: turn' = left turn right, shift' = shift + drift (old shift - old).
struct PoseMap {
  Mat3 left, right, drift;
  Vec3 old, shift, size;

  Pose operator()(const Pose& pose) const {
    Pose carried;
    carried.shift = shift + drift * (pose.shift - old);
    carried.turn = Eigen::Quaterniond(Mat3(left * pose.turn.toRotationMatrix() * right)).normalized();
    carried.scale = pose.scale.cwiseQuotient(size);
    return carried;
  }
};

PoseMap pose_map(const Rig& giver, const Rig& carried, std::size_t number, double scale, Chirality chirality) {
  const Joint& joint = giver.joints[number];
  const Mat4 before = local_bind(giver, number), after = local_bind(carried, number);
  const Pose bound = pose_of(before);
  const Mat3 reversed = Vec3(chirality == Chirality::mirrored ? -1 : 1, 1, 1).asDiagonal();
  PoseMap map{reversed, reversed, scale * reversed, bound.shift, after.topRightCorner<3, 1>(), bound.scale};
  if (joint.parent < 0) {
    map.left = Mat3(after.topLeftCorner<3, 3>()) * reversed * bound.turn.toRotationMatrix().transpose();
    map.drift = scale * map.left;
  } else {
    map.drift *= std::cbrt(std::abs(giver.joints[static_cast<std::size_t>(joint.parent)].bind.topLeftCorner<3, 3>().determinant()));
  }
  for (double& size : map.size) size = size == 0 ? 1 : size;
  return map;
}

std::vector<Pose> carry_poses(const std::vector<Pose>& poses, const PoseMap& map) {
  std::vector<Pose> carried;
  for (const Pose& pose : poses) {
    carried.push_back(map(pose));
    if (carried.size() > 1 && carried[carried.size() - 2].turn.dot(carried.back().turn) < 0) {
      carried.back().turn.coeffs() = -carried.back().turn.coeffs();  // the same turn, on the shorter arc
    }
  }
  return carried;
}

}  // namespace

std::vector<Animation> carry_animations(const AttributedMesh& giver, const Mesh& receiver, const GiverPlaces& on_giver, const Rig& rig) {
  if (giver.animations.empty()) return {};
  const double scale = best_similarity(all_pairs(receiver, on_giver.places), on_giver.chirality).scale;
  std::vector<Animation> carried = giver.animations;
  for (Animation& animation : carried) {
    for (std::size_t i = 0; i < rig.joints.size(); ++i) {
      animation.poses[i] = carry_poses(animation.poses[i], pose_map(giver.rig, rig, i, scale, on_giver.chirality));
    }
  }
  return carried;
}

}  // namespace homolog
