// SPDX-License-Identifier: MIT
#include "homolog/shape/core_share.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace homolog {
namespace {

constexpr std::size_t slices = 1024;
constexpr double left_out = 0.005;  // of the area, on each side

using Areas = std::array<double, slices>;

/// How many slices, from the front, hold less than what is left out.
template <class Slice>
std::size_t outside(Slice slice, double area) {
  std::size_t count = 0;
  for (double sum = *slice; sum < left_out * area && count + 1 < slices; sum += *++slice) ++count;
  return count;
}

double area_of(const Mesh& mesh, const Triangle& triangle) {
  const Vec3& a = mesh.vertices[triangle[0]];
  return 0.5 * (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a).norm();
}

}  // namespace

double core_share(const Mesh& mesh) {
  const Box box = bounding_box(mesh);
  const Vec3 extent = box.max - box.min;
  std::array<Areas, 3> areas{};
  for (const Triangle& triangle : mesh.triangles) {
    const double third = area_of(mesh, triangle) / 3;
    for (const std::uint32_t corner : triangle) {
      const Vec3 place = static_cast<double>(slices) * (mesh.vertices[corner] - box.min);
      for (int axis = 0; axis < 3; ++axis) {
        const double slice = extent[axis] > 0 ? place[axis] / extent[axis] : 0;
        areas[axis][std::min(static_cast<std::size_t>(slice), slices - 1)] += third;
      }
    }
  }
  Vec3 core;
  for (int axis = 0; axis < 3; ++axis) {
    const double area = std::accumulate(areas[axis].begin(), areas[axis].end(), 0.0);
    if (!(area > 0)) return 1;
    const std::size_t kept = slices - outside(areas[axis].begin(), area) - outside(areas[axis].rbegin(), area);
    core[axis] = extent[axis] * static_cast<double>(kept) / slices;
  }
  return core.norm() / box.diagonal();
}

std::string told_core(const Mesh& mesh) {
  const double share = core_share(mesh);
  if (share >= least_core_share) return "";
  return fmt::format("97 % of its surface lie within {:.2g} % of its box; remove what lies far away, or choose --part", 100 * share);
}

}  // namespace homolog
