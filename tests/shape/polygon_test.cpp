// SPDX-License-Identifier: MIT
#include "homolog/shape/polygon.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

namespace homolog {
namespace {

Mesh triangulated(const std::vector<Vec3>& outline) {
  Mesh mesh{outline, {}};
  std::vector<std::uint32_t> corners(outline.size());
  std::iota(corners.begin(), corners.end(), 0u);
  append_polygon(mesh, corners);
  return mesh;
}

/// Sums of |area| and of signed area along z: equal when no triangle is folded over.
std::pair<double, double> areas(const Mesh& mesh) {
  double absolute = 0, along_z = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 normal = (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]) / 2;
    absolute += normal.norm();
    along_z += normal.z();
  }
  return {absolute, along_z};
}

TEST(Polygon, ConcaveOutlinesAreFilledOnce) {
  const std::vector<std::vector<Vec3>> outlines = {
      {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}},  // dart, area 4
      {{1, 1, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}},  // the same from its inner corner
      {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}},  // hook with a straight corner
  };
  for (const auto& outline : outlines) {
    const Mesh mesh = triangulated(outline);
    EXPECT_EQ(mesh.triangles.size(), outline.size() - 2);
    const auto [absolute, along_z] = areas(mesh);
    EXPECT_NEAR(absolute, along_z, 1e-12);
  }
  EXPECT_NEAR(areas(triangulated(outlines[0])).first, 4, 1e-12);
  EXPECT_NEAR(areas(triangulated(outlines[2])).first, 3 + 2 + 1, 1e-12);
}

TEST(Polygon, StarsAndLargePolygonsWork) {
  std::vector<Vec3> star, circle;
  for (int i = 0; i < 60; ++i) {
    const double radius = i % 2 ? 1 : 3;
    star.emplace_back(radius * std::cos(M_PI * i / 30), radius * std::sin(M_PI * i / 30), 0);
  }
  for (int i = 0; i < 5000; ++i) circle.emplace_back(std::cos(M_PI * i / 2500), std::sin(M_PI * i / 2500), 0);
  const auto [absolute, along_z] = areas(triangulated(star));
  EXPECT_NEAR(absolute, along_z, 1e-9);
  EXPECT_NEAR(absolute, 30 * 3 * std::sin(M_PI / 30), 1e-9);
  EXPECT_NEAR(areas(triangulated(circle)).first, M_PI, 1e-5);
}

/// Between two zigzags that mesh like teeth, every second corner is turned in.
std::vector<Vec3> comb(int corners) {
  std::vector<Vec3> outline;
  for (int i = 0; i < corners / 2; ++i) outline.emplace_back(i, i % 2, 0);
  for (int i = corners / 2 - 1; i >= 0; --i) outline.emplace_back(i, i % 2 + 0.5, 0);
  return outline;
}

TEST(Polygon, CombsAreFilledOnceAndHugeOnesSoonWithTheSameWinding) {
  const auto [absolute, along_z] = areas(triangulated(comb(500)));
  EXPECT_NEAR(absolute, along_z, 1e-9);
  EXPECT_NEAR(along_z, 249 * 0.5, 1e-9);
  EXPECT_NEAR(areas(triangulated(comb(40000))).second, 19999 * 0.5, 1e-6);
}

TEST(Polygon, WavyOutlinesOfManyCornersAreFilledOnce) {
  std::vector<Vec3> outline;
  constexpr int corners = 40000;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners,
                 radius = 1 + 0.3 * std::sin(3 * angle) + 0.1 * std::sin(11 * angle) + 0.002 * std::sin(900 * angle);
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  const auto [absolute, along_z] = areas(triangulated(outline));
  EXPECT_NEAR(absolute, along_z, 1e-9);
  EXPECT_NEAR(along_z, M_PI * (1 + (0.09 + 0.01 + 4e-6) / 2), 1e-5);
}

TEST(Polygon, PointsAndLinesAddNothing) {
  Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
  for (const std::vector<std::uint32_t>& corners : {std::vector<std::uint32_t>{}, {0}, {0, 1}, {0, 0, 1}, {0, 1, 1, 0}}) {
    append_polygon(mesh, corners);
  }
  EXPECT_TRUE(mesh.triangles.empty());
}

}  // namespace
}  // namespace homolog
