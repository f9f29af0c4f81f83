// SPDX-License-Identifier: MIT
#include "surface_ways.h"

#include <gtest/gtest.h>

#include <cmath>

#include "homolog/shape/vertex_normals.h"
#include "score.h"

namespace homolog::bench {
namespace {

/// A strip of n by n squares bent by z = height(x), each cut in two along the same diagonal.
template <class Height>
Mesh sheet(std::uint32_t n, Height height) {
  Mesh mesh;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t j = 0; j <= n; ++j) mesh.vertices.emplace_back(1.0 * i / n, 1.0 * j / n, height(1.0 * i / n));
  }
  const auto at = [n](std::uint32_t i, std::uint32_t j) { return i * (n + 1) + j; };
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

double way(const Mesh& mesh, const Vec3& a, const Vec3& b) {
  const NearestSurface surface(mesh, vertex_normals(mesh));
  const SurfaceWays ways(mesh);
  const SurfacePlace start = *surface.nearest(a, Vec3::Zero(), 1e9), end = *surface.nearest(b, Vec3::Zero(), 1e9);
  return ways.to(end, start, ways.from(start));
}

TEST(SurfaceWays, AreStraightOnAPlaneUpToTheTriangles) {
  const Mesh flat = sheet(20, [](double) { return 0.0; });
  EXPECT_NEAR(area_of(flat), 1, 1e-12);
  for (const Vec3& end : {Vec3(0.9, 0.9, 0), Vec3(0.9, 0.13, 0), Vec3(0.13, 0.9, 0), Vec3(0.5, 0.8, 0), Vec3(0.131, 0.121, 0)}) {
    const double straight = (end - Vec3(0.12, 0.12, 0)).norm(), measured = way(flat, {0.12, 0.12, 0}, end);
    EXPECT_GE(measured, straight - 1e-12);
    EXPECT_LE(measured, 1.04 * straight + 0.01);
  }
}

TEST(SurfaceWays, GoAroundWhatIsBetween) {
  const Mesh ridge = sheet(20, [](double x) { return 2 * std::min(x, 1 - x); });
  EXPECT_NEAR(way(ridge, {0, 0.5, 0}, {1, 0.5, 0}), std::sqrt(5), 1e-9);  // over the ridge, straight along the edges
}

TEST(SurfaceWays, ReachNoOtherComponent) {
  const Mesh two{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_EQ(way(two, {0.2, 0.2, 0}, {0.2, 0.2, 1}), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(way(two, {0.2, 0.2, 0}, {0.3, 0.2, 0}), 0.1, 1e-12);
}

TEST(SurfaceWays, TellHowFarLandmarksAreOff) {
  const Mesh data = sheet(20, [](double) { return 0.0; });
  TruePoints points{.dense = false};
  for (const Vec3& x : {Vec3(0.2, 0.2, 0), Vec3(0.8, 0.2, 0), Vec3(0.2, 0.8, 0), Vec3(0.7, 0.7, 0), Vec3(0.5, 0.4, 0)}) {
    points.model.push_back(x + Vec3(0, 0, 0.3));  // what is off across the surface does not count
    points.data.push_back(x + Vec3(0.1, 0, 0));
  }
  const SourceSystem system(points.model, std::vector<double>(points.model.size()));
  const auto same = ThinPlateSpline::similarity_free(system, points.model, Chirality::proper);
  for (const double error : errors_along_surface(same, make_truth(points).direct, data)) EXPECT_NEAR(error, 0.1, 1e-9);
}

}  // namespace
}  // namespace homolog::bench
