// SPDX-License-Identifier: MIT
// Sec. 4.2. Rays along the three axes find where the winding number is not 0; their mean is the coverage, which makes thin slanted
// plates as smooth as thick ones. Where the surface has holes the three axes vote, and the share they could not agree on is told.
#include "homolog/shape/voxelize.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "homolog/base/errors.h"
#include "homolog/shape/clip.h"
#include "homolog/shape/orient.h"
#include "homolog/shape/ray_columns.h"

namespace homolog {
namespace {

constexpr float agreement = 0.5f;  // rays of two axes sample the skin differently, but the inside of a voxel not by more than this

struct Vote {
  float coverage;
  bool agreed;
};

void check_mesh(const Mesh& mesh) {
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (corner >= mesh.vertices.size()) {
        throw ShapeError(fmt::format("a triangle names vertex {}, but there are {}", corner, mesh.vertices.size()));
      }
      if (!mesh.vertices[corner].allFinite()) throw ShapeError(fmt::format("a coordinate of vertex {} is not a finite number", corner));
    }
  }
}

void check_resolution(int resolution) {
  if (resolution < 1 || resolution > 2048) {
    throw ParamError(fmt::format("parameter 'resolution' is {}, but must be from 1 to 2048", resolution));
  }
}

void check_inside(const Interior& interior, bool closed) {
  if (std::any_of(interior.values.begin(), interior.values.end(), [](float v) { return v > 0; })) return;
  throw ShapeError(closed ? "the shape encloses no volume; give a solid, not a flat sheet"
                          : "the surface has holes too large to tell its inside; close it (fill the holes in a mesh editor) and try again");
}

Box part_in_world(const Box& whole, const Box& share) {
  if (!(share.min.array() >= 0).all() || !(share.max.array() <= 1).all() || !(share.min.array() < share.max.array()).all()) {
    throw ParamError("a part must be a box of shares from 0 to 1, each minimum below its maximum");
  }
  const Vec3 extent = whole.max - whole.min;
  return {whole.min + share.min.cwiseProduct(extent), whole.min + share.max.cwiseProduct(extent)};
}

/// A tight grid of cubic voxels around a box and in its middle, with a margin of one voxel.
GridFrame make_frame(const Box& box, int resolution) {
  if (!(box.min.array() <= box.max.array()).all()) {
    throw ShapeError("there is nothing of the shape in this part of its box; choose a larger part");
  }
  GridFrame frame;
  const Vec3 extent = box.max - box.min;
  frame.spacing = extent.maxCoeff() / resolution;
  if (!std::isfinite(frame.spacing) || !(frame.spacing > 0)) {
    throw ShapeError("the shape has no extent, or one too large for numbers; scale it");
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double voxels = std::ceil(extent[axis] / frame.spacing - 1e-9);  // rounding must not add a voxel
    frame.size[axis] = std::max(1, static_cast<int>(voxels)) + 2;
    frame.origin[axis] = box.min[axis] + extent[axis] / 2 - frame.spacing * (frame.size[axis] - 1) / 2;
  }
  return frame;
}

GridSurface to_grid(const Mesh& mesh, OrientedSurface&& surface, const GridFrame& frame, const Box& part) {
  const Vec3 corner = frame.origin - Vec3::Constant(frame.spacing / 2);
  const Vec3 size(frame.size[0], frame.size[1], frame.size[2]);
  GridSurface grid{frame.size, {}, std::move(surface.triangles), {}};
  grid.vertices.reserve(mesh.vertices.size());
  for (const Vec3& vertex : mesh.vertices) grid.vertices.push_back((vertex - corner) / frame.spacing);
  grid.part.min = ((part.min - corner) / frame.spacing).cwiseMax(Vec3::Zero()).cwiseMin(size);
  grid.part.max = ((part.max - corner) / frame.spacing).cwiseMax(Vec3::Zero()).cwiseMin(size);
  return grid;
}

/// A closed surface: every ray closes and all axes are equally right.
Voxels average_axes(const GridSurface& surface, const GridFrame& frame) {
  AxisCoverage coverage{std::vector<float>(frame.voxels(), 0), {}};
  for (int axis = 0; axis < 3; ++axis) add_ray_coverage(surface, axis, coverage);
  for (float& value : coverage.sums) value /= 3.0f * full_coverage;
  return {{frame, std::move(coverage.sums)}, 0};
}

/// Columns that close decide: by their mean when they agree, a single one alone; else the median of all three.
Vote vote(const std::array<float, 3>& value, const std::array<bool, 3>& open) {
  float sum = 0, low = 2, high = -1;
  int closed = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (open[axis]) continue;
    ++closed;
    sum += value[axis];
    low = std::min(low, value[axis]);
    high = std::max(high, value[axis]);
  }
  if (closed > 0 && high - low <= agreement) return {sum / static_cast<float>(closed), closed == 3};
  return {std::max(std::min(value[0], value[1]), std::min(std::max(value[0], value[1]), value[2])), false};
}

Voxels vote_axes(const GridSurface& surface, const GridFrame& frame) {
  std::array<AxisCoverage, 3> axes;
  for (int axis = 0; axis < 3; ++axis) {
    axes[axis].sums.assign(frame.voxels(), 0);
    add_ray_coverage(surface, axis, axes[axis]);
  }
  Voxels voxels{{frame, std::vector<float>(frame.voxels())}, 0};
  double inside = 0, guessed = 0;
  const auto& n = frame.size;
  for (std::size_t i = 0; i < frame.voxels(); ++i) {
    const std::size_t x = i % n[0], y = i / n[0] % n[1], z = i / n[0] / n[1];
    const std::array<bool, 3> open{axes[0].open[y + z * n[1]] != 0, axes[1].open[x + z * n[0]] != 0, axes[2].open[x + y * n[0]] != 0};
    const Vote result = vote({axes[0].sums[i] / full_coverage, axes[1].sums[i] / full_coverage, axes[2].sums[i] / full_coverage}, open);
    voxels.interior.values[i] = result.coverage;
    inside += result.coverage;
    guessed += result.agreed ? 0 : result.coverage;
  }
  if (inside > 0) voxels.guessed = guessed / inside;
  return voxels;
}

}  // namespace

Voxels voxelize(const Mesh& mesh, int resolution, const std::optional<Box>& part) {
  check_resolution(resolution);
  check_mesh(mesh);
  const Box whole = bounding_box(mesh);
  const Box limits = part ? part_in_world(whole, *part) : whole;
  OrientedSurface surface = orient(mesh);
  const bool closed = surface.closed;
  const Box bounds = part ? clipped_bounding_box(mesh.vertices, surface.triangles, limits) : whole;
  const GridFrame frame = make_frame(bounds, resolution);
  const GridSurface grid = to_grid(mesh, std::move(surface), frame, limits);
  Voxels voxels = closed ? average_axes(grid, frame) : vote_axes(grid, frame);
  check_inside(voxels.interior, closed);
  return voxels;
}

}  // namespace homolog
