// SPDX-License-Identifier: MIT
#include "homolog/shape/clip.h"

#include <limits>

#include "homolog/shape/ray_crossing.h"

namespace homolog {
namespace {

using Polygon = std::vector<Vec3>;

/// The side of the plane x[axis] = limit that is below it (sign 1) or above it (-1); Sutherland & Hodgman 1974.
Polygon clip_by_plane(const Polygon& polygon, int axis, double limit, int sign) {
  Polygon clipped;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double beyond_a = sign * (a[axis] - limit), beyond_b = sign * (b[axis] - limit);
    if (beyond_a <= 0) clipped.push_back(a);
    if ((beyond_a <= 0) == (beyond_b <= 0)) continue;
    clipped.push_back(a + beyond_a / (beyond_a - beyond_b) * (b - a));
    clipped.back()[axis] = limit;
  }
  return clipped;
}

void extend(Box& bounds, const Vec3& point) {
  bounds.min = bounds.min.cwiseMin(point);
  bounds.max = bounds.max.cwiseMax(point);
}

}  // namespace

Box clipped_bounding_box(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles, const Box& box) {
  Box bounds;
  bounds.min.setConstant(std::numeric_limits<double>::infinity());
  bounds.max = -bounds.min;
  std::array<int, 8> winding{};
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i) {
    corners[i] = {(i & 1 ? box.max : box.min).x(), (i & 2 ? box.max : box.min).y(), (i & 4 ? box.max : box.min).z()};
  }
  for (const auto& [a, b, c] : triangles) {
    Polygon polygon{vertices[a], vertices[b], vertices[c]};
    for (int axis = 0; axis < 3; ++axis) {
      polygon = clip_by_plane(polygon, axis, box.max[axis], 1);
      polygon = clip_by_plane(polygon, axis, box.min[axis], -1);
    }
    for (const Vec3& point : polygon) extend(bounds, point);
    for (int i = 0; i < 8; ++i) winding[i] += crossing_beyond(vertices[a], vertices[b], vertices[c], corners[i]);
  }
  for (int i = 0; i < 8; ++i) {
    if (winding[i] != 0) extend(bounds, corners[i]);
  }
  return bounds;
}

}  // namespace homolog
