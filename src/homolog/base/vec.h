// SPDX-License-Identifier: MIT
// The linear-algebra names used everywhere: points, matrices and similarities of 3-space.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace homolog {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Mat4 = Eigen::Matrix4d;

}  // namespace homolog
