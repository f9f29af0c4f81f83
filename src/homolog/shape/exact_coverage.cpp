// SPDX-License-Identifier: MIT
// Triangles are cut at the borders of layers of z, then of rows of y, then of voxels along x. A piece within one voxel adds its area, seen
// along x, to the voxels behind it, and a share of it to its own.
#include "homolog/shape/exact_coverage.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <utility>

#include "homolog/base/large_memory.h"
#include "homolog/base/parallel.h"

namespace homolog {
namespace {

constexpr double step = 0x1p-20;     // sums are rounded to it, so that they return to exactly 0 and 1
constexpr double overlap = 0x1p-10;  // what is so far below 0 or above 1 is no rounding
constexpr int layers_a_task = 8;
constexpr std::size_t row_block = 8;  // voxels that are looked at together for whether anything changes

/// A triangle cut by at most six planes.
struct Polygon {
  int count = 0;
  std::array<Vec3, 9> corners;

  void add(const Vec3& corner) { corners[count++] = corner; }
};

struct Range {
  double low, high;
};

float in_steps(double sum) {  // std::round() is a call
  return static_cast<float>(static_cast<double>(static_cast<std::int64_t>(sum / step + (sum < 0 ? -0.5 : 0.5))) * step);
}

Range range_of(const Polygon& polygon, int axis) {
  Range range{polygon.corners[0][axis], polygon.corners[0][axis]};
  for (int i = 1; i < polygon.count; ++i) {
    range.low = std::min(range.low, polygon.corners[i][axis]);
    range.high = std::max(range.high, polygon.corners[i][axis]);
  }
  return range;
}

/// Splits a polygon at the plane x[axis] = limit.
void split(const Polygon& whole, int axis, double limit, Polygon& below, Polygon& above) {
  below.count = above.count = 0;
  const Vec3* last = &whole.corners[whole.count - 1];
  double last_height = (*last)[axis] - limit;
  for (int i = 0; i < whole.count; ++i) {
    const Vec3& next = whole.corners[i];
    const double height = next[axis] - limit;
    if ((height < 0) != (last_height < 0)) {
      Vec3 cut = *last + last_height / (last_height - height) * (next - *last);
      cut[axis] = limit;
      below.add(cut);
      above.add(cut);
    }
    (height < 0 ? below : above).add(next);
    last = &next;
    last_height = height;
  }
}

/// Calls body(cell, piece) for the pieces of a polygon in the cells [i, i + 1] of an axis, of which there are `cells`.
template <class Body>
void for_each_piece(const Polygon& polygon, int axis, int cells, const Body& body) {
  const Range range = range_of(polygon, axis);
  int cell = std::min(static_cast<int>(range.low), cells - 1);
  if (range.high <= cell + 1) return body(cell, polygon);
  Polygon below, above[2];
  const Polygon* rest = &polygon;
  for (; cell + 1 < range.high; ++cell) {
    Polygon& next = above[rest == above ? 1 : 0];
    split(*rest, axis, cell + 1, below, next);
    body(cell, below);
    rest = &next;
  }
  body(cell, *rest);
}

/// What of a polygon is in a range; `clipped` when it had to be cut.
const Polygon& keep(const Polygon& polygon, int axis, const Range& kept, Polygon (&clipped)[2]) {
  const Range range = range_of(polygon, axis);
  const Polygon* rest = &polygon;
  Polygon beside;
  if (range.low < kept.low) {
    split(*rest, axis, kept.low, beside, clipped[0]);
    rest = &clipped[0];
  }
  if (range.high > kept.high) {
    if (rest->count > 0) split(*rest, axis, kept.high, clipped[1], beside);
    rest = rest->count > 0 ? &clipped[1] : rest;
  }
  return *rest;
}

/// One layer of voxels: differences to the voxel before, along x.
class CoverageLayer {
 public:
  explicit CoverageLayer(const GridSurface& surface)
      : surface_(surface),
        stride_((surface.size[0] + 2 + row_block - 1) / row_block * row_block),
        differences_(stride_ * surface.size[1]),
        touched_(surface.size[1]) {}

  void add(const Triangle& triangle, int z) {
    Polygon whole, cut_z[2], cut_y[2];
    for (const std::uint32_t corner : triangle) whole.add(surface_.vertices[corner]);
    const Box& part = surface_.part;
    const Polygon& in_layer = keep(whole, 2, {std::max<double>(z, part.min.z()), std::min<double>(z + 1, part.max.z())}, cut_z);
    if (in_layer.count == 0) return;
    const Polygon& in_part = keep(in_layer, 1, {part.min.y(), part.max.y()}, cut_y);
    if (in_part.count == 0) return;
    for_each_piece(in_part, 1, surface_.size[1], [&](int y, const Polygon& piece) { add_to_row(piece, y); });
  }

  /// Sums up row y and forgets it. False when it is seen that shells overlap in it.
  bool take_row(int y, float* coverage) {
    if (!touched_[y]) return true;
    touched_[y] = false;
    const auto size = static_cast<std::size_t>(surface_.size[0]);
    double* row = differences_.data() + y * stride_;
    double sum = 0, least = 0, most = 1;
    float rounded = 0;
    for (std::size_t block = 0; block < size; block += row_block) {
      const std::size_t end = std::min(block + row_block, size);
      if (std::all_of(row + block, row + block + row_block, [](double d) { return d == 0; })) {
        if (rounded != 0) std::fill(coverage + block, coverage + end, rounded);
        continue;
      }
      for (std::size_t x = block; x < end; ++x) {
        sum += row[x];
        least = std::min(least, sum);
        most = std::max(most, sum);
        coverage[x] = rounded = in_steps(sum);
      }
      std::fill(row + block, row + block + row_block, 0.0);
    }
    std::fill(row + size, row + stride_, 0.0);
    return least > -overlap && most < 1 + overlap;
  }

 private:
  void add_to_row(const Polygon& polygon, int y) {
    touched_[y] = 1;
    const double low = surface_.part.min.x(), high = surface_.part.max.x();
    const Range range = range_of(polygon, 0);
    if (range.low >= low && range.high <= high) return add_pieces(polygon, y);
    Polygon before, rest, within, behind;  // what lies beyond the part is before or behind all of it, as it is at its border
    split(polygon, 0, low, before, rest);
    if (rest.count > 0) split(rest, 0, high, within, behind);
    for (int i = 0; i < before.count; ++i) before.corners[i].x() = low;
    for (int i = 0; i < behind.count; ++i) behind.corners[i].x() = high;
    for (const Polygon* piece : {&before, &within, &behind}) {
      if (piece->count > 0) add_pieces(*piece, y);
    }
  }

  void add_pieces(const Polygon& polygon, int y) {
    double* row = differences_.data() + y * stride_;
    for_each_piece(polygon, 0, surface_.size[0] + 1, [&](int x, const Polygon& piece) { add_piece(piece, x, row + x); });
  }

  static void add_piece(const Polygon& piece, int x, double* voxel) {
    const Vec3& a = piece.corners[0];
    double area = 0, moment = 0;  // twice the area, six times its moment about x = 0
    for (int i = 2; i < piece.count; ++i) {
      const Vec3 &b = piece.corners[i - 1], &c = piece.corners[i];
      const double part = (b.z() - a.z()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.z() - a.z());
      area += part;
      moment += part * (a.x() + b.x() + c.x());
    }
    const double beyond = moment / 6 - area / 2 * x;  // integral of (x' - x) dy dz: what the piece bounds within its own voxel
    voxel[0] += area / 2 - beyond;
    voxel[1] += beyond;
  }

  const GridSurface& surface_;
  std::size_t stride_;
  std::vector<double> differences_;
  std::vector<std::uint8_t> touched_;
};

}  // namespace

std::vector<float> exact_coverage(const GridSurface& surface) {
  const RayBundle bundle = make_bundle(surface, 0);
  std::vector<float> coverage = large_zeros(surface.voxels());
  std::atomic<bool> overlaps = false;
  const int nx = surface.size[0], ny = surface.size[1], nz = surface.size[2];
  parallel_for((nz + layers_a_task - 1) / layers_a_task, [&](std::size_t task) {
    CoverageLayer layer(surface);
    const int first = static_cast<int>(task) * layers_a_task;
    for (int z = first; z < std::min(first + layers_a_task, nz) && !overlaps; ++z) {
      for (std::uint32_t n = bundle.begin[z]; n < bundle.begin[z + 1]; ++n) layer.add(surface.triangles[bundle.numbers[n]], z);
      for (int y = 0; y < ny; ++y) {
        if (!layer.take_row(y, coverage.data() + (static_cast<std::size_t>(z) * ny + y) * nx)) overlaps = true;
      }
    }
  });
  if (overlaps) return {};
  return coverage;
}

}  // namespace homolog
