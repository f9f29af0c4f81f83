// SPDX-License-Identifier: MIT
// Where a triangle cuts the rows of rays of one layer of voxels: cut_row() of ray_crossing.h for four rows at once.
#pragma once

#include <cstdint>

#include "homolog/base/widest_clone.h"
#include "homolog/shape/ray_crossing.h"

namespace homolog {

using FourMasks [[gnu::vector_size(32)]] = std::int64_t;  ///< -1 where true, 0 where not
using FourInts [[gnu::vector_size(16)]] = std::int32_t;

/// As in RowCut, row by row; from = to where the row does not cross the triangle.
struct RowCuts {
  FourDoubles from, to, depth_from, depth_to;
  FourMasks downward;
};

/// Cuts the triangle abc at four rows.
[[gnu::always_inline]] inline RowCuts cut_rows(const Vec3& a, const Vec3& b, const Vec3& c, const RayAxes& axes, const FourDoubles& rows) {
  const Vec3* corners[4] = {&a, &b, &c, &a};
  FourDoubles up_column{}, up_depth{};      // where the edge that goes up meets the row
  FourDoubles down_column{}, down_depth{};  // and the one that goes down
  for (int i = 0; i < 3; ++i) {
    const Vec3 &start = *corners[i], &end = *corners[i + 1];
    const FourMasks starts_above = start[axes.row] >= rows, ends_above = end[axes.row] >= rows;
    const Vec3 &low = start[axes.row] < end[axes.row] ? start : end, &high = start[axes.row] < end[axes.row] ? end : start;
    const FourDoubles share = (rows - low[axes.row]) / (high[axes.row] - low[axes.row]);
    const FourDoubles column = low[axes.column] + share * (high[axes.column] - low[axes.column]);
    const FourDoubles depth = low[axes.depth] + share * (high[axes.depth] - low[axes.depth]);
    const FourMasks up = ends_above & ~starts_above, down = starts_above & ~ends_above;
    up_column = up ? column : up_column, up_depth = up ? depth : up_depth;
    down_column = down ? column : down_column, down_depth = down ? depth : down_depth;
  }
  const FourMasks swapped = up_column > down_column;
  return {swapped ? down_column : up_column, swapped ? up_column : down_column, swapped ? down_depth : up_depth,
          swapped ? up_depth : down_depth, swapped};
}

}  // namespace homolog
