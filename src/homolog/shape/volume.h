// SPDX-License-Identifier: MIT
// Values on a regular grid, and where the grid lies in the world.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "homolog/base/vec.h"

namespace homolog {

/// Voxel (i, j, k) has its centre at origin + spacing * axes * (i, j, k); i runs fastest in memory.
struct GridFrame {
  std::array<int, 3> size{0, 0, 0};
  Vec3 origin = Vec3::Zero();
  double spacing = 1;
  Mat3 axes = Mat3::Identity();  ///< columns: the directions of i, j and k; a rotation

  std::size_t voxels() const { return static_cast<std::size_t>(size[0]) * size[1] * size[2]; }
  std::size_t index(int i, int j, int k) const { return (static_cast<std::size_t>(k) * size[1] + j) * size[0] + i; }
  bool contains(int i, int j, int k) const { return i >= 0 && j >= 0 && k >= 0 && i < size[0] && j < size[1] && k < size[2]; }
  Vec3 world_from_voxel(const Vec3& v) const { return origin + spacing * (axes * v); }
  Vec3 voxel_from_world(const Vec3& x) const { return axes.transpose() * (x - origin) / spacing; }
};

template <class T>
struct Volume {
  GridFrame frame;
  std::vector<T> values;

  T& at(int i, int j, int k) { return values[frame.index(i, j, k)]; }
  const T& at(int i, int j, int k) const { return values[frame.index(i, j, k)]; }
};

/// The characteristic function chi of a solid (Sec. 4.2), as the share of each voxel that is inside, 0 to 1.
using Interior = Volume<float>;

/// Trilinear value at a world point; 0 outside the grid.
float sample(const Volume<float>& volume, const Vec3& world);

}  // namespace homolog
