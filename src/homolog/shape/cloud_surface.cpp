// SPDX-License-Identifier: MIT
// Every point becomes a splat, a triangle of its share of the surface; inside is where the splats wind around. The surface of these voxels
// is then moved to where they wind exactly half around, which no longer shows the voxels.
#include "homolog/shape/cloud_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "homolog/base/errors.h"
#include "homolog/base/parallel.h"
#include "homolog/shape/agreeing_normals.h"
#include "homolog/shape/mesh_pieces.h"
#include "homolog/shape/nearest_points.h"
#include "homolog/shape/settle_by_winding.h"
#include "homolog/shape/splats.h"
#include "homolog/shape/surface_nets.h"
#include "homolog/shape/vertex_normals.h"
#include "homolog/shape/winding_number.h"

namespace homolog {
namespace {

constexpr int least_voxels = 64, most_voxels = 256;  // along the longest side; about as many as shapes are described with
constexpr double voxels_a_root = 4;                  // of the number of points, so that the share of a point is several voxels
constexpr int margin = 2;                            // voxels
constexpr int rounds = 2;                            // of smoothing
constexpr int halvings = 4;                          // of a voxel, which is how far a vertex may go
constexpr double beside = 0.25;                      // sides of a splat: where to look before and behind it
constexpr double least_closed = 0.4;                 // a half ball has .55, a flat sheet 0
constexpr std::size_t least_splats = 100;            // of fewer the surface is a guess that depends on each of them
constexpr std::size_t most_asked = 20000;
constexpr double near = 2, near_sides = 3, far = 0.6;  // voxels, mean sides of a splat, and shares of the way to the last neighbour
constexpr std::size_t neighbours = 24;
constexpr std::size_t speck = 100;    // triangles: noise and the rims of holes leave pieces of fewer, which are no bigger than a few voxels
constexpr double least_extent = 0.5;  // of the points' box that the surface must fill
constexpr double stray = 100;         // medians: a point with so large a share of the surface stands ten times as far from its neighbours
constexpr double most_strays = 0.02, most_stray_area = 0.1;  // shares: so few points must not make so much of the surface

/// Splats in grid coordinates: voxel i covers [i, i + 1].
struct Splats {
  PointCloud cloud;
  std::vector<double> areas;
  GridSurface surface;
};

Box box_of(const std::vector<Vec3>& points) {
  Box box{points[0], points[0]};
  for (const Vec3& point : points) box.min = box.min.cwiseMin(point), box.max = box.max.cwiseMax(point);
  return box;
}

/// Turns all normals when most of the surface looks inward.
void turn_outward(PointCloud& cloud, const std::vector<double>& areas) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& point : cloud.points) mean += point / static_cast<double>(cloud.points.size());
  double volume = 0;
  for (std::size_t i = 0; i < areas.size(); ++i) volume += areas[i] * (cloud.points[i] - mean).dot(cloud.normals[i]) / 3;
  if (volume >= 0) return;
  for (Vec3& normal : cloud.normals) normal = -normal;
}

Splats make_splats(PointCloud cloud, const Vec3& corner, double spacing, const Vec3& extent) {
  for (Vec3& point : cloud.points) point = (point - corner) / spacing + Vec3::Constant(margin);
  Splats splats{thinned(cloud, 1), {}, {}};
  turn_overruled(splats.cloud);
  splats.areas = point_areas(splats.cloud);
  turn_outward(splats.cloud, splats.areas);
  Mesh triangles = triangles_about(splats.cloud, splats.areas);
  splats.surface.vertices = std::move(triangles.vertices);
  splats.surface.triangles = std::move(triangles.triangles);
  for (int axis = 0; axis < 3; ++axis) splats.surface.size[axis] = static_cast<int>(std::ceil(extent[axis] / spacing)) + 2 * margin;
  splats.surface.part = {Vec3::Zero(), Vec3(splats.surface.size[0], splats.surface.size[1], splats.surface.size[2])};
  return splats;
}

/// How closed the surface is: 1 if wholly, 0 for a flat sheet or normals without order. The mean of how often it winds around places just
/// before and just behind it, twice; a splat's own share of that cancels out, and so does noise.
double closedness(const Splats& splats, const WindingNumber& winding) {
  const std::size_t count = splats.areas.size(), asked = std::min(count, most_asked);
  std::vector<double> turns(asked);
  parallel_for(asked, [&](std::size_t task) {
    const std::size_t i = task * count / asked;
    const Vec3 step = beside * std::sqrt(splats.areas[i]) * splats.cloud.normals[i];
    turns[task] = winding.at(splats.cloud.points[i] - step) + winding.at(splats.cloud.points[i] + step);
  });
  return std::accumulate(turns.begin(), turns.end(), 0.0) / static_cast<double>(asked);
}

[[noreturn]] void refuse_outliers(const std::string& file) {
  throw FileError(fmt::format("{}: a few points lie far from all others, so that these are too small to see; remove the outliers", file));
}

/// Where single points among many, or outside, would be most of the surface.
void refuse_strays(std::vector<double> areas, const std::string& file) {
  const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
  std::nth_element(areas.begin(), middle, areas.end());
  const auto first = std::partition(areas.begin(), areas.end(), [limit = stray * *middle](double area) { return area <= limit; });
  const double strays = std::accumulate(first, areas.end(), 0.0), all = std::accumulate(areas.begin(), first, strays);
  const auto count = areas.end() - first;
  if (static_cast<double>(count) > most_strays * static_cast<double>(areas.size()) || strays <= most_stray_area * all) return;
  throw FileError(
      fmt::format("{}: {} points stand far from all others, but would make {:.0f} % of the surface; remove the outliers (in "
                  "MeshLab, CloudCompare or Open3D, say)",
                  file, count, 100 * strays / all));
}

std::vector<float> coverage_of(const Splats& splats, const std::string& file) {
  const std::size_t voxels = splats.surface.voxels();
  std::vector<float> coverage(voxels, 0);
  try {
    settle_by_winding(splats.surface, std::vector<std::uint8_t>(voxels, 1), coverage);
  } catch (const ShapeError&) {
    throw FileError(fmt::format(
        "{}: its points fill the room so loosely that their inside would take minutes; smooth the cloud, or thin it out", file));
  }
  return coverage;
}

Mesh voxel_surface(const Splats& splats, const std::vector<float>& coverage) {
  Mesh mesh = surface_nets({splats.surface.size,
                            [&](int z, std::vector<float>& slice) {
                              const auto first = coverage.begin() + static_cast<std::ptrdiff_t>(slice.size()) * z;
                              std::copy(first, first + static_cast<std::ptrdiff_t>(slice.size()), slice.begin());
                            }},
                           rounds);
  for (Vec3& vertex : mesh.vertices) vertex += Vec3::Constant(0.5);
  return mesh;
}

/// Moves every vertex along its normal to where the splats wind half around, if that is within a voxel.
void move_to_half(Mesh& mesh, const WindingNumber& winding) {
  const std::vector<Vec3> normals = oriented_normals(mesh);
  parallel_for(mesh.vertices.size(), [&](std::size_t i) {
    const auto is_inside = [&](double way) { return winding.at(mesh.vertices[i] + way * normals[i]) > 0.5; };
    const bool inside = is_inside(0);
    double here = 0, beyond = inside ? 1 : -1;
    if (is_inside(beyond) == inside) return;
    for (int k = 0; k < halvings; ++k) {
      const double middle = (here + beyond) / 2;
      (is_inside(middle) == inside ? here : beyond) = middle;
    }
    mesh.vertices[i] += (here + beyond) / 2 * normals[i];
  });
}

/// For every vertex whether a point is near, for the density of all or of those around it. Where none is, the surface is only guessed.
std::vector<std::uint8_t> near_points(const std::vector<Vec3>& vertices, const Splats& splats) {
  const NearestPoints tree(splats.cloud.points);
  const double area = std::accumulate(splats.areas.begin(), splats.areas.end(), 0.0);
  const double reach = std::max(near, near_sides * std::sqrt(area / static_cast<double>(splats.areas.size())));
  std::vector<std::uint8_t> is_near(vertices.size());
  parallel_for(vertices.size(), [&](std::size_t i) {
    const double nearest = std::sqrt(tree.nearest(vertices[i], 1).front().square_distance);
    is_near[i] = nearest <= reach || nearest <= far * std::sqrt(tree.nearest(vertices[i], neighbours).back().square_distance);
  });
  return is_near;
}

}  // namespace

Mesh cloud_surface(PointCloud cloud, const std::string& file, std::optional<int> voxels) {
  const Box box = box_of(cloud.points);
  const Vec3 extent = box.max - box.min;
  const double wanted = voxels_a_root * std::sqrt(static_cast<double>(cloud.points.size()));
  const int along = voxels.value_or(static_cast<int>(std::clamp<double>(wanted, least_voxels, most_voxels)));
  const double spacing = extent.maxCoeff() / along;
  if (!std::isfinite(spacing) || !(spacing > 0)) {
    throw FileError(fmt::format("{}: the points have no extent, or one too large for numbers; scale them", file));
  }
  const std::size_t points = cloud.points.size();
  const Splats splats = make_splats(std::move(cloud), box.min, spacing, extent);
  if (points >= least_splats && splats.areas.size() < least_splats) refuse_outliers(file);
  refuse_strays(splats.areas, file);
  const WindingNumber winding(splats.surface.vertices, splats.surface.triangles);
  const double closed = closedness(splats, winding);
  if (!(closed >= least_closed)) {
    throw FileError(
        fmt::format("{}: the points enclose {:.0f} % of the room that a closed surface would; orient their normals outward (in "
                    "MeshLab, CloudCompare or Open3D, say), and scan the shape from all sides",
                    file, 100 * std::max(0.0, closed)));
  }
  if (splats.areas.size() < least_splats) {
    throw FileError(fmt::format("{}: {} points, where they differ, are too few to tell a surface; scan more of them, {} at least", file,
                                splats.areas.size(), least_splats));
  }
  Mesh mesh = voxel_surface(splats, coverage_of(splats, file));
  move_to_half(mesh, winding);
  mesh = without_specks(kept_triangles(mesh, near_points(mesh.vertices, splats)), speck);
  if (mesh.triangles.empty())
    throw FileError(fmt::format("{}: the points enclose nothing that is thick enough to see; scan more of them", file));
  const Box filled = box_of(mesh.vertices);
  if ((filled.max - filled.min).maxCoeff() < least_extent * along) refuse_outliers(file);
  for (Vec3& vertex : mesh.vertices) vertex = box.min + spacing * (vertex - Vec3::Constant(margin));
  return mesh;
}

}  // namespace homolog
