// SPDX-License-Identifier: MIT
// Point clouds for the tests of this folder: places drawn evenly from the surface of a mesh, the same on every system.
#pragma once

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "homolog/shape/mesh.h"
#include "homolog/shape/point_cloud.h"

namespace homolog::clouds {

/// `count` places of a mesh whose triangles' fronts are outside, with the normals there.
inline PointCloud sampled(const Mesh& mesh, std::size_t count) {
  std::mt19937 generator(2018);
  const auto unit = [&] { return generator() / 4294967296.0; };
  std::vector<double> sums;
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sums.push_back(sum += (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm());
  }
  PointCloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    const auto place = std::upper_bound(sums.begin(), sums.end(), unit() * sum) - sums.begin();
    const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(place)];
    const Vec3 along = mesh.vertices[b] - mesh.vertices[a], across = mesh.vertices[c] - mesh.vertices[a];
    const double root = std::sqrt(unit()), share = unit();
    cloud.points.push_back(mesh.vertices[a] + root * ((1 - share) * along + share * across));
    cloud.normals.push_back(along.cross(across).normalized());
  }
  return cloud;
}

inline std::string xyz(const PointCloud& cloud) {
  std::string text;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Vec3 &p = cloud.points[i], &n = cloud.normals[i];
    text += fmt::format("{} {} {} {} {} {}\n", p.x(), p.y(), p.z(), n.x(), n.y(), n.z());
  }
  return text;
}

}  // namespace homolog::clouds
