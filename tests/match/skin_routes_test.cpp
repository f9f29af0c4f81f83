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
