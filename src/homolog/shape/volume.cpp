// SPDX-License-Identifier: MIT
#include "homolog/shape/volume.h"

namespace homolog {
namespace {

/// std::floor() is a call where the processor may be an old one. For what fits into a number.
int floor_of(double x) {
  const int towards_zero = static_cast<int>(x);
  return towards_zero - (x < towards_zero ? 1 : 0);
}

}  // namespace

float sample(const Volume<float>& volume, const Vec3& world) {
  const Vec3 v = volume.frame.voxel_from_world(world);
  for (int axis = 0; axis < 3; ++axis) {
    if (!(v[axis] > -1 && v[axis] < volume.frame.size[axis])) return 0;  // also keeps the cast below defined, NaN included
  }
  const int i = floor_of(v.x()), j = floor_of(v.y()), k = floor_of(v.z());
  const double fx = v.x() - i, fy = v.y() - j, fz = v.z() - k;
  const double x[2] = {1 - fx, fx}, y[2] = {1 - fy, fy}, z[2] = {1 - fz, fz};
  double sum = 0;
  if (volume.frame.contains(i, j, k) && volume.frame.contains(i + 1, j + 1, k + 1)) {
    const std::size_t step_y = volume.frame.size[0], step_z = step_y * volume.frame.size[1];
    const float* f = &volume.at(i, j, k);
    for (int corner = 0; corner < 8; ++corner) {
      const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
      sum += x[dx] * y[dy] * z[dz] * f[dx + dy * step_y + dz * step_z];
    }
    return static_cast<float>(sum);
  }
  for (int corner = 0; corner < 8; ++corner) {
    const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
    if (!volume.frame.contains(i + dx, j + dy, k + dz)) continue;
    sum += x[dx] * y[dy] * z[dz] * volume.at(i + dx, j + dy, k + dz);
  }
  return static_cast<float>(sum);
}

}  // namespace homolog
