// SPDX-License-Identifier: MIT
// Sec. 4.2. Coverage is exact where the surface is closed and its shells do not overlap, which makes thin slanted plates as smooth as thick
// ones. Else rays along the three axes find where the winding number is not 0. Where the surface has holes the three axes vote, and the
// share they could not agree on is told.
#include "homolog/shape/voxelize.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "homolog/base/errors.h"
#include "homolog/shape/clip.h"
#include "homolog/shape/core_share.h"
#include "homolog/shape/inside.h"
#include "homolog/shape/orient.h"
#include "homolog/shape/thicken.h"

namespace homolog {
namespace {

constexpr double most_crossings = 2e7;  // of a ray for every column of voxels and the surface: some seconds
constexpr double least_sheets = 64;     // are allowed on the finest grid

void check_settings(int resolution, double thicken) {
  if (resolution < 1 || resolution > 2048) {
    throw ParamError(fmt::format("a grid of {} voxels cannot be made; choose 1 to 2048", resolution));
  }
  if (!(thicken >= 0 && thicken <= 1)) throw ParamError(fmt::format("a thickness of {} diagonals cannot be given; choose 0 to 1", thicken));
}

void check_inside(const Voxels& voxels, const Mesh& mesh, bool is_part) {
  const auto& values = voxels.interior.values;
  if (std::any_of(values.begin(), values.end(), [](float v) { return v > 0; })) return;
  if (const std::string far = is_part ? "" : told_core(mesh); !far.empty())
    throw ShapeError("the shape is too small for its box to have an inside: " + far);
  const char* why = voxels.open == 0 ? "the shape encloses no volume" : "the surface has holes too large to tell its inside";
  throw ShapeError(
      fmt::format("{}; close it (fill the holes in a mesh editor), or give its sheets a thickness (--thicken 0.02, say)", why));
}

Box part_in_world(const Box& whole, const Box& share) {
  if (!(share.min.array() >= 0).all() || !(share.max.array() <= 1).all() || !(share.min.array() < share.max.array()).all()) {
    throw ParamError("a part must be a box of shares from 0 to 1, each minimum below its maximum");
  }
  const Vec3 extent = whole.max - whole.min;
  return {whole.min + share.min.cwiseProduct(extent), whole.min + share.max.cwiseProduct(extent)};
}

/// The box with so much more on every side, as far as the limits allow.
Box grown(const Box& box, double margin, const Box& limits) {
  return {(box.min - Vec3::Constant(margin)).cwiseMax(limits.min), (box.max + Vec3::Constant(margin)).cwiseMin(limits.max)};
}

/// A tight grid of cubic voxels around a box and in its middle, with a margin of one voxel.
GridFrame make_frame(const Box& box, int resolution) {
  if ((box.min.array() > box.max.array()).any()) {  // what is not a number is told below
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

/// Sheets that lie behind each other, in the mean over the face of the box that sees most of them.
double mean_sheets(const GridSurface& grid) {
  const Vec3 size(grid.size[0], grid.size[1], grid.size[2]), faces = size.prod() * size.cwiseInverse();
  Vec3 area = Vec3::Zero();
  for (const auto& [i, j, k] : grid.triangles) {
    const Vec3 &a = grid.vertices[i], &b = grid.vertices[j], &c = grid.vertices[k];
    if ((a.cwiseMax(b).cwiseMax(c).array() < 0).any() || (a.cwiseMin(b).cwiseMin(c) - size).maxCoeff() > 0) continue;  // beside a part
    area += (0.5 * (b - a).cross(c - a).cwiseAbs()).cwiseMin(faces);
  }
  return area.cwiseQuotient(faces).maxCoeff();
}

/// Random triangles through the whole box would be asked for hours.
void check_sheets(const GridSurface& grid) {
  const double columns = std::pow(*std::max_element(grid.size.begin(), grid.size.end()), 2);
  const double sheets = mean_sheets(grid), most = std::max(least_sheets, most_crossings / columns);
  if (sheets <= most) return;
  throw ShapeError(
      fmt::format("its triangles lie {:.0f} deep through its box in the mean, too many for an inside at this resolution (at most "
                  "{:.0f}); remesh it, or leave out what is doubled",
                  sheets, most));
}

}  // namespace

Box thickened_box(const Mesh& mesh, double thicken) {
  Box box = bounding_box(mesh);
  const Vec3 half = Vec3::Constant(thicken * box.diagonal() / 2);
  return {box.min - half, box.max + half};
}

Voxels voxelize(const Mesh& mesh, int resolution, const std::optional<Box>& part, double thicken) {
  check_settings(resolution, thicken);
  check_mesh(mesh);
  const Box whole = thickened_box(mesh, thicken);
  const Box limits = part ? part_in_world(whole, *part) : whole;
  const double thickness = thicken * bounding_box(mesh).diagonal();
  OrientedSurface surface = orient(mesh);
  Voxels voxels{{}, 0, surface.open, surface.components};
  const Box bounds = part ? grown(clipped_bounding_box(mesh.vertices, surface.triangles, limits), thickness / 2, limits) : whole;
  const GridFrame frame = make_frame(bounds, resolution);
  const GridSurface grid = to_grid(mesh, std::move(surface), frame, limits);
  check_sheets(grid);
  Inside inside = voxels.open == 0 ? inside_of_closed(grid) : inside_of_open(grid);
  if (thickness > 0) thicken_surface(grid, thickness / frame.spacing, inside.coverage);
  voxels.interior = {frame, std::move(inside.coverage)};
  voxels.guessed = inside.guessed;
  check_inside(voxels, mesh, part.has_value());
  return voxels;
}

}  // namespace homolog
