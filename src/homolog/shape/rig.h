// SPDX-License-Identifier: MIT
// What moves a mesh: joints with their weights, and shape keys.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "homolog/base/vec.h"

namespace homolog {

struct Joint {
  std::string name;
  int parent = -1;               ///< in Rig::joints; -1: none
  Mat4 bind = Mat4::Identity();  ///< mesh_from_joint in the pose in which the mesh is as it is, of homogeneous columns
};

/// How far a vertex follows a joint.
struct Influence {
  std::uint16_t joint = 0;
  float weight = 0;  ///< 0: not at all
};
using Influences = std::array<Influence, 8>;  ///< the strongest first; their sum is 1, or 0 for a vertex that follows none

/// How many joints a vertex follows at most: four, as all programs that show glTF know them, or all eight where the rig has more than four.
inline constexpr std::size_t few_influences = 4;

struct Rig {
  std::vector<Joint> joints;
  std::vector<Influences> influences;  ///< of every vertex
};

/// parent_from_joint where the mesh is as it is; mesh_from_joint of a joint without a parent.
Mat4 local_bind(const Rig& rig, std::size_t joint);

/// The strongest ones, at most `most` (up to eight), those of one joint as one, so that their sum is 1; all 0 if none is positive. Of equal
/// ones those of the first joints.
Influences strongest_influences(std::vector<Influence> influences, std::size_t most = few_influences);

/// Four, or eight if a vertex follows more than four joints.
std::size_t most_influences(const std::vector<Influences>& influences);

/// Another form of the same mesh, as a face's smile (glTF: morph target).
struct ShapeKey {
  std::string name;
  double weight = 0;                ///< how far the file has it applied, 0: not
  std::vector<Vec3> displacements;  ///< of every vertex
};

/// Where a joint stands in its parent: scaled, then turned, then shifted.
struct Pose {
  Vec3 shift = Vec3::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  Vec3 scale = Vec3::Ones();
};

Mat4 matrix_of(const Pose& pose);

/// The pose nearest to a matrix, which cannot shear. Axes that it draws to nothing stay where they are, with scale 0.
Pose pose_of(const Mat4& matrix);

/// How joints and shape keys move; between two times in a straight line, turns along the shorter arc.
struct Animation {
  std::string name;
  std::vector<double> times;                 ///< in seconds, from 0 on, ascending, each another float
  std::vector<std::vector<Pose>> poses;      ///< of every joint at every time, in its parent; in the mesh's coordinates if it has none
  std::vector<std::vector<double>> weights;  ///< of every shape key at every time
};

}  // namespace homolog
