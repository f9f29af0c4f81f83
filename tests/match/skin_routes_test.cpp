// SPDX-License-Identifier: MIT
#include "homolog/match/skin_routes.h"

#include <gtest/gtest.h>

#include "shape/meshes.h"

namespace homolog {
namespace {

/// The corner k of a triangle.
SurfacePlace corner(const Mesh& mesh, std::uint32_t triangle, int k) {
  return {triangle, Vec3::Unit(k), mesh.vertices[mesh.triangles[triangle][k]], 0};
}

TEST(SkinRoutes, GoAroundASphereNotThroughIt) {
  const Mesh sphere = meshes::sphere(4);
  const SkinRoutes routes(sphere);
  std::uint32_t north = 0, south = 0;
  const auto height = [&](std::uint32_t t) { return sphere.vertices[sphere.triangles[t][2]].z(); };
  for (std::uint32_t t = 0; t < sphere.triangles.size(); ++t) {
    if (height(t) > height(north)) north = t;
    if (height(t) < height(south)) south = t;
  }
  const SurfacePlace from = corner(sphere, north, 2), to = corner(sphere, south, 2);
  ASSERT_EQ(to.position.z(), -1);
  EXPECT_FALSE(routes.within(from, to, 0.99 * M_PI)) << "no way is shorter than half a great circle";
  EXPECT_TRUE(routes.within(from, to, 1.2 * M_PI)) << "ways along edges are a little longer";
  EXPECT_TRUE(routes.within(from, from, 0));
}

/// Lengths of the shortest ways along edges from one vertex to all, by Bellman and Ford.
std::vector<double> plain_lengths(const Mesh& mesh, std::uint32_t from) {
  std::vector<double> length(mesh.vertices.size(), INFINITY);
  length[from] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& triangle : mesh.triangles) {
      for (int k = 0; k < 6; ++k) {
        const std::uint32_t a = triangle[k % 3], b = triangle[(k + 1 + k / 3) % 3];
        const double way = length[a] + (mesh.vertices[a] - mesh.vertices[b]).norm();
        if (way < length[b]) length[b] = way, changed = true;
      }
    }
  }
  return length;
}

TEST(SkinRoutes, AreTheShortestOfAll) {
  const Mesh torus = meshes::torus(1, 0.3, 24, 12);
  const SkinRoutes routes(torus);
  for (std::uint32_t t = 0; t < torus.triangles.size(); t += 97) {
    const std::vector<double> length = plain_lengths(torus, torus.triangles[t][0]);
    for (std::uint32_t u = 0; u < torus.triangles.size(); u += 5) {
      const double shortest = length[torus.triangles[u][1]];
      const auto within = [&](double limit) { return routes.within(corner(torus, t, 0), corner(torus, u, 1), limit); };
      EXPECT_TRUE(within(shortest + 1e-9));
      if (!within(0)) EXPECT_FALSE(within(shortest - 1e-9)) << t << " " << u;  // they do not touch
    }
  }
}

TEST(SkinRoutes, KnowNeighboursWhateverTheirSize) {
  const Mesh box = meshes::box({0, 0, 0}, {100, 100, 100});
  EXPECT_TRUE(SkinRoutes(box).within(corner(box, 0, 0), corner(box, 1, 2), 1));
}

TEST(SkinRoutes, PassSeams) {
  Mesh torus = meshes::torus(1, 0.3, 24, 12);
  Mesh soup;  // every triangle with its own vertices
  for (const auto& triangle : torus.triangles) {
    const auto n = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t vertex : triangle) soup.vertices.push_back(torus.vertices[vertex]);
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  const SkinRoutes routes(soup);
  EXPECT_TRUE(routes.within(corner(soup, 0, 0), corner(soup, 100, 0), 6));
  EXPECT_FALSE(routes.within(corner(soup, 0, 0), corner(soup, 288, 0), 2.1)) << "across the hole";
}

TEST(SkinRoutes, TakePiecesThatLieNearForNear) {
  const Mesh two = meshes::joined(meshes::sphere(2), meshes::moved(meshes::sphere(2), Mat3::Identity(), {2.1, 0, 0}));
  const SkinRoutes routes(two);
  const auto count = static_cast<std::uint32_t>(two.triangles.size() / 2);
  const auto at = [&](double x) {
    for (std::uint32_t t = 0; t < 2 * count; ++t) {
      for (int k = 0; k < 3; ++k) {
        if (std::abs(two.vertices[two.triangles[t][k]].x() - x) < 1e-9) return corner(two, t, k);
      }
    }
    return SurfacePlace{};
  };
  EXPECT_TRUE(routes.within(at(1), at(1.1), 0.2));
  EXPECT_FALSE(routes.within(at(1), at(3.1), 0.2));
}

}  // namespace
}  // namespace homolog
