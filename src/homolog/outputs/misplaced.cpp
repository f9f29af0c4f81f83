// SPDX-License-Identifier: MIT
#include "homolog/outputs/misplaced.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "homolog/describe/surface_samples.h"
#include "homolog/shape/nearest_points.h"
#include "homolog/shape/nearest_surface.h"
#include "homolog/shape/vertex_normals.h"

namespace homolog {
namespace {

constexpr double enough = 0.75;  // share that must lie there
constexpr double far = 0.1;      // diagonals
constexpr std::size_t several = 3;
constexpr double least_extent = 0.01;  // diagonals that several landmarks span

struct Turn {
  const char* told;
  Mat3 turn;
};

const Turn turns[] = {{"", Mat3::Identity()},
                      {"turned from Z up to Y up", (Mat3() << 1, 0, 0, 0, 0, 1, 0, -1, 0).finished()},
                      {"turned from Y up to Z up", (Mat3() << 1, 0, 0, 0, 0, -1, 0, 1, 0).finished()},
                      {"turned between RAS and LPS", (Mat3() << -1, 0, 0, 0, -1, 0, 0, 0, 1).finished()}};

/// Of corners of its triangles that lie near samples; of large meshes some of them are enough.
double share_of_mesh(const Mesh& mesh, const NearestPoints& samples, double reach) {
  const std::size_t step = mesh.triangles.size() / 10000 + 1;
  std::size_t near = 0, all = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += step, ++all) {
    near += samples.nearest(mesh.vertices[mesh.triangles[t][0]], 1)[0].square_distance <= reach * reach;
  }
  return static_cast<double>(near) / static_cast<double>(all);
}

double share_of_samples(const Mesh& mesh, const std::vector<Vec3>& samples, double reach) {
  const NearestSurface surface(mesh, vertex_normals(mesh));
  const auto near = std::count_if(samples.begin(), samples.end(),
                                  [&](const Vec3& sample) { return surface.nearest(sample, Vec3::Zero(), reach).has_value(); });
  return static_cast<double>(near) / static_cast<double>(samples.size());
}

/// The larger of the two shares. Near is what decimation and voxels move at most, and the space between samples.
double share_in_place(const Mesh& mesh, const MatchedShape& shape) {
  const std::vector<Vec3>& samples = shape.samples.positions;
  const double reach = std::max(0.02 * shape.diagonal, 1.5 * typical_spacing(samples)) + shape.thickness / 2 * shape.diagonal;
  const double of_mesh = share_of_mesh(mesh, NearestPoints(samples), reach);
  return of_mesh >= enough ? of_mesh : std::max(of_mesh, share_of_samples(mesh, samples, reach));
}

/// By which sizes differ; units by powers of ten, exactly.
double scale_to(const MatchedShape& shape, const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& sample : shape.samples.positions) box.extend(sample);
  const double size = bounding_box(mesh).diagonal(), ratio = size > 0 ? box.diagonal().norm() / size : 1;
  const double power = std::pow(10, std::round(std::log10(ratio)));
  return std::abs(ratio / power - 1) < 0.05 ? power : ratio;
}

/// What would bring the mesh to its place, as "turned from Z up to Y up and scaled by 0.001"; empty if nothing that is known does. Sizes
/// that differ need not be wrong: the mesh or the shape may be but a part.
std::string told_way(const Mesh& mesh, const MatchedShape& shape, const std::vector<double>& scales) {
  for (const double scale : scales) {
    for (const auto& [told, turn] : turns) {
      Mesh moved = mesh;
      for (Vec3& x : moved.vertices) x = scale * (turn * x);
      if (share_in_place(moved, shape) < enough) continue;
      return scale == 1 ? told : fmt::format("{}{}scaled by {:.4g}", told, *told ? " and " : "", scale);
    }
  }
  return "";
}

}  // namespace

MatchedShape carried_from(const MatchMap& match, Direction direction, const std::string& name) {
  if (direction == Direction::data_from_model) return {name, match.model, match.model_diagonal, match.thickness};
  return {name, match.data, match.data_diagonal, match.thickness};
}

std::optional<Misplaced> misplaced(const Mesh& mesh, const std::string& file, const MatchedShape& shape) {
  if (shape.samples.positions.empty()) return {};
  const bool tiny = bounding_box(mesh).diagonal() < 0.1 * shape.diagonal, in_place = share_in_place(mesh, shape) >= enough;
  if (in_place && !tiny) return {};
  const double scale = scale_to(shape, mesh);
  const std::string way = told_way(mesh, shape, tiny ? std::vector{scale} : std::vector{1.0, scale});
  if (in_place && way.empty()) return {};  // a small part; the whole in another unit may lie near the surface, too
  return Misplaced{
      fmt::format("{}: it does not lie where {} lay when that was matched{}; save it with the axes and in the unit of that one", file,
                  shape.name, way.empty() ? "" : fmt::format(", but would if {}", way)),
      !way.empty()};
}

std::string misplaced_points(const std::vector<Vec3>& points, const std::string& file, const MatchedShape& shape) {
  if (shape.samples.positions.empty() || points.empty()) return "";
  constexpr const char* question = "are they in its coordinates and its unit?";
  Eigen::AlignedBox3d box;
  for (const Vec3& point : points) box.extend(point);
  const double extent = box.diagonal().norm() / shape.diagonal;
  if (points.size() >= several && extent < least_extent) {
    return fmt::format("the {} points of {} lie within {:.2g} % of the diagonal of {}; {}", points.size(), file, 100 * extent, shape.name,
                       question);
  }
  const NearestPoints samples(shape.samples.positions);
  const auto is_far = [&](const Vec3& x) { return std::sqrt(samples.nearest(x, 1)[0].square_distance) > far * shape.diagonal; };
  const auto count = static_cast<std::size_t>(std::count_if(points.begin(), points.end(), is_far));
  if (2 * count <= points.size()) return "";
  return fmt::format("{} of {} points of {} are farther from {} than a tenth of its diagonal; {}", count, points.size(), file, shape.name,
                     question);
}

}  // namespace homolog
