// SPDX-License-Identifier: MIT
// Where rays along an axis cross triangles, without leaks: a row of rays is cut edge by edge, from the edge's lower end to its upper
// one, so that the two triangles of an edge compute the same number and every ray between or on them counts exactly one of the two.
#pragma once

#include <algorithm>

#include "homolog/base/vec.h"

namespace homolog {

/// The axes of a bundle of rays: they run along `depth`; `row` numbers the rows of rays and `column` the rays in a row.
struct RayAxes {
  int depth, column, row;
};

inline constexpr RayAxes ray_axes[3] = {{0, 1, 2}, {1, 0, 2}, {2, 0, 1}};

/// The rays of one row that cross a triangle: those with from <= column < to, upward or downward (sign), at a linearly changing depth.
struct RowCut {
  double from, to, depth_from, depth_to;
  int sign;

  double depth_at(double column) const {
    const double share = to > from ? (column - from) / (to - from) : 0;
    return depth_from + std::clamp(share, 0.0, 1.0) * (depth_to - depth_from);
  }
};

/// Cuts the triangle abc at a row. False when the row does not cross it; a corner on the row counts as above.
inline bool cut_row(const Vec3& a, const Vec3& b, const Vec3& c, const RayAxes& axes, double row, RowCut& cut) {
  const Vec3* corners[4] = {&a, &b, &c, &a};
  double column[2], depth[2];  // where the edge that goes up, and the one that goes down, meet the row
  bool crosses = false;
  for (int i = 0; i < 3; ++i) {
    const bool starts_above = (*corners[i])[axes.row] >= row, ends_above = (*corners[i + 1])[axes.row] >= row;
    if (starts_above == ends_above) continue;
    const Vec3 &low = *corners[starts_above ? i + 1 : i], &high = *corners[starts_above ? i : i + 1];
    const double share = (row - low[axes.row]) / (high[axes.row] - low[axes.row]);
    column[starts_above] = low[axes.column] + share * (high[axes.column] - low[axes.column]);
    depth[starts_above] = low[axes.depth] + share * (high[axes.depth] - low[axes.depth]);
    crosses = true;
  }
  if (!crosses) return false;
  const int first = column[0] <= column[1] ? 0 : 1;
  cut = {column[first], column[1 - first], depth[first], depth[1 - first], first == 0 ? 1 : -1};
  return true;
}

/// How the ray from a point along +x crosses the triangle abc: 1, -1 or 0. Summed over a closed surface: the point's winding number.
inline int crossing_beyond(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point) {
  const RayAxes& axes = ray_axes[0];
  const double column = point[axes.column];
  RowCut cut;
  if (!cut_row(a, b, c, axes, point[axes.row], cut) || column < cut.from || column >= cut.to) return 0;
  return cut.depth_at(column) > point[axes.depth] ? cut.sign : 0;
}

}  // namespace homolog
