// SPDX-License-Identifier: MIT
#include "homolog/shape/ray_columns.h"

#include <algorithm>
#include <cmath>

#include "homolog/base/parallel.h"
#include "homolog/shape/ray_crossing.h"

namespace homolog {
namespace {

/// The rays' places along one direction across them: the middles of the voxels' shares that lie in the part, and how wide these are.
struct Places {
  std::vector<double> middle, width;  // width 1 when wholly in the part, 0 when outside
};

struct Crossing {
  int column;
  int sign;
  double depth;
};

/// The triangles that may cross each row of rays: those of row r are numbers[begin[r]] to numbers[begin[r + 1]].
struct RowBins {
  std::vector<std::uint32_t> begin, numbers;
};

/// What the rays of one row of voxels work on. Coverage is summed as differences along the ray in whole numbers, so that it returns to
/// exactly 0 behind the solid.
struct Row {
  const GridSurface& surface;
  const RayAxes& axes;
  const Places& columns;
  std::vector<Crossing> found, sorted;
  std::vector<std::uint32_t> column_begin;
  std::vector<std::int32_t> differences;
  std::size_t column_stride, depth_stride;
  std::vector<float> lost, sent;  // weights of the rays that do not close, and of all
};

Places place_rays(int voxels, double part_min, double part_max) {
  Places places;
  for (int i = 0; i < voxels * rays_per_voxel; ++i) {
    const double low = std::max(part_min, static_cast<double>(i) / rays_per_voxel);
    const double high = std::min(part_max, static_cast<double>(i + 1) / rays_per_voxel);
    places.middle.push_back((low + high) / 2);
    places.width.push_back(std::max(0.0, (high - low) * rays_per_voxel));
  }
  return places;
}

RowBins bin_rows(const GridSurface& surface, int row_axis) {
  const int rows = surface.size[row_axis] * rays_per_voxel;
  const auto range = [&](const std::array<std::uint32_t, 3>& t, int& first, int& last) {
    const double a = surface.vertices[t[0]][row_axis], b = surface.vertices[t[1]][row_axis], c = surface.vertices[t[2]][row_axis];
    const double low = std::min({a, b, c}) * rays_per_voxel, high = std::max({a, b, c}) * rays_per_voxel;
    first = static_cast<int>(std::clamp(std::floor(low), 0.0, static_cast<double>(rows)));
    last = static_cast<int>(std::clamp(std::floor(high), -1.0, rows - 1.0));
  };
  RowBins bins;
  bins.begin.assign(rows + 1, 0);
  int first, last;
  for (const auto& t : surface.triangles) {
    range(t, first, last);
    for (int row = first; row <= last; ++row) ++bins.begin[row + 1];
  }
  for (int row = 0; row < rows; ++row) bins.begin[row + 1] += bins.begin[row];
  bins.numbers.resize(bins.begin[rows]);
  std::vector<std::uint32_t> next(bins.begin.begin(), bins.begin.end() - 1);
  for (std::uint32_t number = 0; number < surface.triangles.size(); ++number) {
    range(surface.triangles[number], first, last);
    for (int row = first; row <= last; ++row) bins.numbers[next[row]++] = number;
  }
  return bins;
}

/// The first ray whose place is at or beyond `column`.
int first_ray_from(const Places& places, double column) {
  const int count = static_cast<int>(places.middle.size());
  int ray = static_cast<int>(std::clamp(std::floor(column * rays_per_voxel), 0.0, static_cast<double>(count)));
  while (ray > 0 && places.middle[ray - 1] >= column) --ray;
  while (ray < count && places.middle[ray] < column) ++ray;
  return ray;
}

void find_crossings(Row& row, const std::uint32_t* first, const std::uint32_t* last, double place) {
  row.found.clear();
  const auto& vertices = row.surface.vertices;
  for (const std::uint32_t* number = first; number != last; ++number) {
    const auto& [a, b, c] = row.surface.triangles[*number];
    RowCut cut;
    if (!cut_row(vertices[a], vertices[b], vertices[c], row.axes, place, cut)) continue;
    const int end = static_cast<int>(row.columns.middle.size());
    for (int ray = first_ray_from(row.columns, cut.from); ray < end && row.columns.middle[ray] < cut.to; ++ray) {
      row.found.push_back({ray, cut.sign, cut.depth_at(row.columns.middle[ray])});
    }
  }
}

/// By ray, then by depth; the order of equal depths is of no effect, as nothing lies between them.
void sort_crossings(Row& row) {
  const std::size_t rays = row.columns.middle.size();
  row.column_begin.assign(rays + 1, 0);
  for (const Crossing& crossing : row.found) ++row.column_begin[crossing.column + 1];
  for (std::size_t ray = 0; ray < rays; ++ray) row.column_begin[ray + 1] += row.column_begin[ray];
  row.sorted.resize(row.found.size());
  for (const Crossing& crossing : row.found) row.sorted[row.column_begin[crossing.column]++] = crossing;
  for (std::size_t ray = rays; ray > 0; --ray) row.column_begin[ray] = row.column_begin[ray - 1];
  row.column_begin[0] = 0;
  for (std::size_t ray = 0; ray < rays; ++ray) {
    std::sort(row.sorted.begin() + row.column_begin[ray], row.sorted.begin() + row.column_begin[ray + 1],
              [](const Crossing& a, const Crossing& b) { return a.depth < b.depth; });
  }
}

/// Adds `weight` to everything beyond a depth.
void add_from(Row& row, std::int32_t* line, double depth, std::int32_t weight) {
  const double clipped = std::clamp(depth, row.surface.part.min[row.axes.depth], row.surface.part.max[row.axes.depth]);
  const auto voxel = static_cast<std::size_t>(clipped);
  const auto next = static_cast<std::int32_t>(std::lround(weight * (clipped - static_cast<double>(voxel))));
  line[voxel * row.depth_stride] += weight - next;
  line[(voxel + 1) * row.depth_stride] += next;
}

void add_ray(Row& row, std::size_t ray, std::int32_t weight) {
  const Crossing* first = row.sorted.data() + row.column_begin[ray];
  const Crossing* last = row.sorted.data() + row.column_begin[ray + 1];
  const std::size_t column = ray / rays_per_voxel;
  row.sent[column] += static_cast<float>(weight);
  int winding = 0;
  for (const Crossing* crossing = first; crossing != last; ++crossing) winding += crossing->sign;
  if (winding != 0) {
    row.lost[column] += static_cast<float>(weight);
    return;
  }
  std::int32_t* line = row.differences.data() + column * row.column_stride;
  bool inside = false;
  for (const Crossing* crossing = first; crossing != last; ++crossing) {
    winding += crossing->sign;
    const bool now = winding != 0;
    if (now != inside) add_from(row, line, crossing->depth, now ? weight : -weight);
    inside = now;
  }
}

/// Sums the differences along the rays and adds them to the voxels.
void store(const Row& row, std::size_t number, AxisCoverage& coverage) {
  const auto& size = row.surface.size;
  const std::size_t strides[3] = {1, static_cast<std::size_t>(size[0]), static_cast<std::size_t>(size[0]) * size[1]};
  const std::size_t columns = size[row.axes.column];
  float* target = coverage.sums.data() + number * strides[row.axes.row];
  std::vector<std::int32_t> sum(columns, 0);
  for (std::size_t depth = 0; depth < static_cast<std::size_t>(size[row.axes.depth]); ++depth) {
    const std::int32_t* line = row.differences.data() + depth * row.depth_stride;
    float* voxels = target + depth * strides[row.axes.depth];
    for (std::size_t column = 0; column < columns; ++column) {
      sum[column] += line[column * row.column_stride];
      voxels[column * strides[row.axes.column]] += static_cast<float>(sum[column]);
    }
  }
  for (std::size_t column = 0; column < columns; ++column) {
    if (row.lost[column] > 0) coverage.lost[number * columns + column] = row.lost[column] / row.sent[column];
  }
}

}  // namespace

void add_ray_coverage(const GridSurface& surface, int axis, AxisCoverage& coverage) {
  const RayAxes& axes = ray_axes[axis];
  const Box& part = surface.part;
  const Places columns = place_rays(surface.size[axes.column], part.min[axes.column], part.max[axes.column]);
  const Places rows = place_rays(surface.size[axes.row], part.min[axes.row], part.max[axes.row]);
  const RowBins bins = bin_rows(surface, axes.row);
  const std::size_t column_count = surface.size[axes.column], depth_count = surface.size[axes.depth] + 2;
  coverage.lost.assign(column_count * surface.size[axes.row], 0);
  parallel_for(surface.size[axes.row], [&](std::size_t number) {
    Row row{surface, axes, columns, {}, {}, {}, {}, 1, column_count, std::vector<float>(column_count, 0), {}};
    row.sent = row.lost;
    row.differences.assign(column_count * depth_count, 0);
    const std::size_t first_row = number * rays_per_voxel, end_row = first_row + rays_per_voxel;
    if (bins.begin[first_row] == bins.begin[end_row]) return;
    for (std::size_t r = first_row; r < end_row; ++r) {
      if (rows.width[r] == 0) continue;
      find_crossings(row, bins.numbers.data() + bins.begin[r], bins.numbers.data() + bins.begin[r + 1], rows.middle[r]);
      sort_crossings(row);
      for (std::size_t ray = 0; ray < columns.middle.size(); ++ray) {
        const auto weight = static_cast<std::int32_t>(std::lround(65536 * rows.width[r] * columns.width[ray]));
        if (weight > 0) add_ray(row, ray, weight);
      }
    }
    store(row, number, coverage);
  });
}

}  // namespace homolog
