// SPDX-License-Identifier: MIT
#include "homolog/shape/ray_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "homolog/base/widest_clone.h"
#include "homolog/shape/row_cuts.h"

namespace homolog {
namespace {

constexpr std::int32_t none = -1;
constexpr double depth_steps = 65536;  // a voxel; as many as a whole ray weighs
constexpr int rays_at_once = 4;
constexpr std::size_t row_block = 16;  // rows are as long as vectors that fit

using FourInMemory [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = std::int32_t;

[[gnu::always_inline]] inline FourInMemory& four_of(std::int32_t* p) { return *reinterpret_cast<FourInMemory*>(p); }

static_assert(rays_per_voxel == 4, "cut_rows() cuts the rows of a layer");

RayPlaces place_rays(int voxels, double part_min, double part_max) {
  RayPlaces places;
  for (int i = 0; i < voxels * rays_per_voxel; ++i) {
    const double cell_min = static_cast<double>(i) / rays_per_voxel, cell_max = static_cast<double>(i + 1) / rays_per_voxel;
    const double low = std::max(part_min, cell_min), high = std::min(part_max, cell_max);
    places.middle.push_back(low < high ? (low + high) / 2 : (cell_min + cell_max) / 2);
    places.width.push_back(std::max(0.0, (high - low) * rays_per_voxel));
  }
  places.middle.insert(places.middle.end(), rays_at_once, std::numeric_limits<double>::infinity());
  return places;
}

/// 0 for what is not a number, too.
double limited(double x, double most) { return x > 0 ? std::min(x, most) : 0; }

/// Numbers of the rays in whose cells these columns lie; `rays` for what lies beyond the last one.
[[gnu::always_inline]] inline FourInts cells_of(const FourDoubles& columns, std::size_t rays) {
  const FourDoubles cells = rays_per_voxel * columns, none_before = cells > 0 ? cells : FourDoubles{},
                    last = FourDoubles{} + static_cast<double>(rays);
  return __builtin_convertvector(none_before < last ? none_before : last, FourInts);
}

void sort_into_layers(const GridSurface& surface, RayBundle& bundle) {
  const int axis = bundle.axes.row, layers = surface.size[axis];
  const auto range = [&](const Triangle& t) {
    const auto [low, high] = std::minmax({surface.vertices[t[0]][axis], surface.vertices[t[1]][axis], surface.vertices[t[2]][axis]});
    return std::pair{static_cast<int>(limited(low, layers)), high < 0 ? -1 : static_cast<int>(limited(high, layers - 1))};
  };
  bundle.begin.assign(layers + 2, 0);
  for (const auto& t : surface.triangles) {
    const auto [first, last] = range(t);
    for (int layer = first; layer <= last; ++layer) ++bundle.begin[layer + 2];
  }
  for (int layer = 1; layer < layers; ++layer) bundle.begin[layer + 2] += bundle.begin[layer + 1];
  bundle.numbers.resize(bundle.begin[layers + 1]);
  for (std::uint32_t number = 0; number < surface.triangles.size(); ++number) {
    const auto [first, last] = range(surface.triangles[number]);
    for (int layer = first; layer <= last; ++layer) bundle.numbers[bundle.begin[layer + 1]++] = number;
  }
}

/// One row of a triangle: the depth there as a linear function of the column.
struct DepthOnRow {
  double column, inverse_length, depth, way;
  int downward;
};

/// Crossings of a layer, many at once: those beyond the end of a row are written, too, but not kept.
struct Crossings {
  std::int32_t count;
  FourDoubles least_depth, most_depth;
  const double* columns;
  std::vector<std::int32_t>&places, &next;

  void make_room(std::size_t more) {
    if (places.size() >= count + more) return;
    places.resize(2 * count + more);
    next.resize(places.size());
  }

  /// Of the rays [ray, end) of a row, whose first crossings are given.
  [[gnu::always_inline]] void add(const DepthOnRow& row, int ray, int end, std::int32_t* first) {
    constexpr FourInts four{0, 1, 2, 3};
    do {
      const FourDoubles share = (*reinterpret_cast<const FourDoubles*>(columns + ray) - row.column) * row.inverse_length;
      const FourDoubles depth = row.depth + (share < 1 ? share : 1 + FourDoubles{}) * row.way;
      const FourDoubles deep_enough = depth > least_depth ? depth : least_depth;
      const FourInts steps = __builtin_convertvector((deep_enough < most_depth ? deep_enough : most_depth) + 0.5, FourInts);
      FourInMemory& before = four_of(first + ray);
      four_of(places.data() + count) = 2 * steps + row.downward;
      four_of(next.data() + count) = before;
      before = four < end - ray ? count + four : before;
      count += std::clamp(end - ray, 0, rays_at_once);
      ray += rays_at_once;
    } while (ray < end);
  }
};

std::int32_t weight_of_ray(const RayBundle& bundle, std::size_t row, std::size_t column) {
  return static_cast<std::int32_t>(depth_steps * bundle.rows.width[row] * bundle.columns.width[column] + 0.5);
}

/// Of all rays through a column of voxels.
float weight_of_column(const RayBundle& bundle, std::size_t layer, std::size_t column) {
  std::int32_t sum = 0;
  for (std::size_t r = 0; r < rays_per_voxel; ++r) {
    for (std::size_t c = 0; c < rays_per_voxel; ++c) {
      sum += weight_of_ray(bundle, layer * rays_per_voxel + r, column * rays_per_voxel + c);
    }
  }
  return static_cast<float>(sum);
}

}  // namespace

RayBundle make_bundle(const GridSurface& surface, int axis) {
  const RayAxes& axes = ray_axes[axis];
  const Box& part = surface.part;
  RayBundle bundle{axes,
                   place_rays(surface.size[axes.column], part.min[axes.column], part.max[axes.column]),
                   place_rays(surface.size[axes.row], part.min[axes.row], part.max[axes.row]),
                   {},
                   {}};
  sort_into_layers(surface, bundle);
  return bundle;
}

LayerRays::LayerRays(const GridSurface& surface, const RayBundle& bundle)
    : surface_(surface), bundle_(bundle), first_(rays_per_voxel * bundle.columns.width.size() + rays_at_once, none) {}

Layer LayerRays::empty_layer() const {
  const RayAxes& axes = bundle_.axes;
  const std::size_t columns = surface_.size[axes.column], depths = surface_.size[axes.depth] + 2;  // differences reach one beyond
  const std::size_t row = axes.depth == 0 ? depths : columns, rows = axes.depth == 0 ? columns : depths;
  const std::size_t stride = (row + row_block - 1) / row_block * row_block;
  return {stride, std::vector<std::int32_t>(stride * rows, 0), std::vector<float>(columns, 0), false};
}

HOMOLOG_WIDEST_CLONE void LayerRays::find_crossings(int number) {
  const RayAxes& axes = bundle_.axes;
  const double* columns = bundle_.columns.middle.data();
  const std::size_t rays = bundle_.columns.width.size();
  const double* rows = bundle_.rows.middle.data() + static_cast<std::ptrdiff_t>(number) * rays_per_voxel;
  const FourDoubles four_rows{rows[0], rows[1], rows[2], rows[3]};
  const double least = depth_steps * surface_.part.min[axes.depth], most = depth_steps * surface_.part.max[axes.depth];
  Crossings crossings{0, least + FourDoubles{}, most + FourDoubles{}, columns, places_, next_};
  for (std::uint32_t n = bundle_.begin[number]; n < bundle_.begin[number + 1]; ++n) {
    const auto& [a, b, c] = surface_.triangles[bundle_.numbers[n]];
    const RowCuts cuts = cut_rows(surface_.vertices[a], surface_.vertices[b], surface_.vertices[c], axes, four_rows);
    const FourInts from = cells_of(cuts.from, rays), to = cells_of(cuts.to, rays);
    const FourDoubles depth = depth_steps * cuts.depth_from, way = depth_steps * (cuts.depth_to - cuts.depth_from);
    const FourDoubles inverse = 1 / (cuts.to - cuts.from);
    crossings.make_room(rays_per_voxel * (rays + rays_at_once));
    for (int r = 0; r < rays_per_voxel; ++r) {
      const int first = from[r] + (columns[from[r]] < cuts.from[r] ? 1 : 0), end = to[r] + (columns[to[r]] < cuts.to[r] ? 1 : 0);
      crossings.add({cuts.from[r], inverse[r], depth[r], way[r], cuts.downward[r] ? 1 : 0}, first, end, first_.data() + r * rays);
    }
  }
}

void LayerRays::add_ray(std::int32_t first, std::int32_t weight, std::size_t column, Layer& layer) {
  of_ray_.clear();
  int winding = 0;
  for (std::int32_t crossing = first; crossing != none; crossing = next_[crossing]) {
    of_ray_.push_back(places_[crossing]);
    winding += places_[crossing] & 1 ? -1 : 1;
  }
  if (winding != 0) {
    layer.lost[column] += static_cast<float>(weight);
    layer.any_lost = true;
    return;
  }
  if (of_ray_.size() == 2) {
    std::tie(of_ray_[0], of_ray_[1]) = std::pair(std::min(of_ray_[0], of_ray_[1]), std::max(of_ray_[0], of_ray_[1]));
  } else {
    std::sort(of_ray_.begin(), of_ray_.end());
  }
  const std::size_t depth_stride = bundle_.axes.depth == 0 ? 1 : layer.stride;
  std::int32_t* line = layer.differences.data() + column * (bundle_.axes.depth == 0 ? layer.stride : 1);
  for (const std::int32_t place : of_ray_) {
    const bool inside = winding != 0;
    winding += place & 1 ? -1 : 1;
    if ((winding != 0) == inside) continue;
    const auto beyond = static_cast<std::int32_t>((static_cast<std::int64_t>(weight) * (place >> 1 & 0xffff) + 0x8000) >> 16);
    std::int32_t* voxel = line + (place >> 17) * static_cast<std::ptrdiff_t>(depth_stride);
    voxel[0] += inside ? beyond - weight : weight - beyond;
    voxel[depth_stride] += inside ? -beyond : beyond;
  }
}

void LayerRays::follow(int number, Layer& layer) {
  std::fill(layer.lost.begin(), layer.lost.end(), 0.0f);
  layer.any_lost = false;
  if (bundle_.begin[number] == bundle_.begin[number + 1]) return;
  find_crossings(number);
  const std::size_t rays = bundle_.columns.width.size();
  for (std::size_t r = 0; r < rays_per_voxel; ++r) {
    for (std::size_t ray = 0; ray < rays; ++ray) {
      std::int32_t& first = first_[r * rays + ray];
      if (first == none) continue;
      const std::int32_t weight = weight_of_ray(bundle_, number * rays_per_voxel + r, ray);
      if (weight > 0) add_ray(first, weight, ray / rays_per_voxel, layer);
      first = none;
    }
  }
  for (std::size_t column = 0; layer.any_lost && column < layer.lost.size(); ++column) {
    if (layer.lost[column] > 0) layer.lost[column] /= weight_of_column(bundle_, number, column);
  }
}

}  // namespace homolog
