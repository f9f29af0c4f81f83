// SPDX-License-Identifier: MIT
#include "homolog/shape/splats.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "homolog/base/parallel.h"
#include "homolog/shape/agreeing_normals.h"
#include "homolog/shape/nearest_points.h"

namespace homolog {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr std::size_t neighbours = 24;
constexpr double other_side = -0.5;  // a cosine between normals: below it, a neighbour is on the other side of a sheet
constexpr std::size_t points_a_task = 256;

/// Where a point lies among the others: its cell, and the axis and side that its normal points to.
struct Place {
  std::array<std::int32_t, 3> cell;
  int side;
  std::uint32_t number;
  auto operator<=>(const Place&) const = default;
};

std::vector<Place> sorted_places(const PointCloud& cloud, double cell) {
  Vec3 low = cloud.points[0];
  for (const Vec3& point : cloud.points) low = low.cwiseMin(point);
  std::vector<Place> places;
  places.reserve(cloud.points.size());
  for (std::uint32_t i = 0; i < cloud.points.size(); ++i) {
    int axis = 0;
    cloud.normals[i].cwiseAbs().maxCoeff(&axis);
    const Vec3 at = (cloud.points[i] - low) / cell;
    places.push_back({{static_cast<std::int32_t>(at.x()), static_cast<std::int32_t>(at.y()), static_cast<std::int32_t>(at.z())},
                      2 * axis + (cloud.normals[i][axis] < 0),
                      i});
  }
  std::sort(places.begin(), places.end());
  return places;
}

/// Past the last place with the cell and side of this one.
std::size_t end_of_group(const std::vector<Place>& places, std::size_t first) {
  std::size_t last = first;
  while (last < places.size() && places[last].cell == places[first].cell && places[last].side == places[first].side) ++last;
  return last;
}

/// Whether the groups that begin at these places lie in one cell and look to opposite sides; the second follows the first.
bool is_opposite(const std::vector<Place>& places, std::size_t first, std::size_t second) {
  return second < places.size() && first < second && places[first].cell == places[second].cell && places[first].side % 2 == 0 &&
         places[second].side == places[first].side + 1;
}

/// Keeps of a convex polygon what is nearer to the origin than to q.
void cut_towards(const Vec2& q, std::vector<Vec2>& polygon, std::vector<Vec2>& cut) {
  cut.clear();
  const auto beyond = [&](const Vec2& x) { return x.dot(q) - q.squaredNorm() / 2; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = beyond(a), at_b = beyond(b);
    if (at_a <= 0) cut.push_back(a);
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) cut.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  polygon.swap(cut);
}

double area_of(const std::vector<Vec2>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return sum / 2;
}

/// The Voronoi cell of a point within a square that reaches to the farthest neighbour. Neighbours are turned down into the plane, so that
/// those around an edge keep their distance.
double area_among(std::uint32_t number, const std::vector<NearestPoints::Neighbour>& nearest, const PointCloud& cloud) {
  const Vec3 &point = cloud.points[number], &normal = cloud.normals[number], u = normal.unitOrthogonal(), v = normal.cross(u);
  const double reach = std::sqrt(nearest.back().square_distance);
  std::vector<Vec2> cell{{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}}, cut;
  for (const auto& neighbour : nearest) {
    if (neighbour.number == number || normal.dot(cloud.normals[neighbour.number]) < other_side) continue;
    const Vec3 way = cloud.points[neighbour.number] - point;
    const Vec2 flat(way.dot(u), way.dot(v));
    if (flat.norm() > 0) cut_towards(flat * (way.norm() / flat.norm()), cell, cut);
  }
  return area_of(cell);
}

}  // namespace

PointCloud thinned(const PointCloud& cloud, double cell) {
  PointCloud thin;
  if (cloud.points.empty()) return thin;
  const std::vector<Place> places = sorted_places(cloud, cell);
  std::size_t before = 0;  // where the group before begins
  for (std::size_t first = 0, last = 0; first < places.size(); before = first, first = last) {
    last = end_of_group(places, first);
    if (is_opposite(places, before, first) && first - before >= overruled_by * (last - first)) continue;
    if (is_opposite(places, first, last) && end_of_group(places, last) - last >= overruled_by * (last - first)) continue;
    Vec3 point = Vec3::Zero(), normal = Vec3::Zero();
    for (std::size_t i = first; i < last; ++i) {
      point += cloud.points[places[i].number];
      normal += cloud.normals[places[i].number].stableNormalized();
    }
    thin.points.push_back(point / static_cast<double>(last - first));
    thin.normals.push_back(normal.normalized());
  }
  return thin;
}

std::vector<double> point_areas(const PointCloud& cloud) {
  const NearestPoints tree(cloud.points);
  std::vector<double> areas(cloud.points.size());
  parallel_for((areas.size() + points_a_task - 1) / points_a_task, [&](std::size_t task) {
    const std::size_t first = task * points_a_task, end = std::min(areas.size(), first + points_a_task);
    for (std::size_t i = first; i < end; ++i) {
      const auto number = static_cast<std::uint32_t>(i);
      areas[i] = area_among(number, tree.nearest(cloud.points[i], neighbours + 1), cloud);
    }
  });
  return areas;
}

Mesh triangles_about(const PointCloud& cloud, const std::vector<double>& areas) {
  Mesh mesh;
  mesh.vertices.reserve(3 * areas.size());
  mesh.triangles.reserve(areas.size());
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const Vec3 u = cloud.normals[i].unitOrthogonal(), v = cloud.normals[i].cross(u);
    const double radius = std::sqrt(4 * areas[i] / std::sqrt(27));
    const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const double angle : {0.0, 2 * M_PI / 3, 4 * M_PI / 3}) {
      mesh.vertices.push_back(cloud.points[i] + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    mesh.triangles.push_back({n, n + 1, n + 2});
  }
  return mesh;
}

}  // namespace homolog
