// SPDX-License-Identifier: MIT
#include "homolog/shape/orient.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <random>
#include <set>

#include "shape/meshes.h"

namespace homolog {
namespace {

double oriented_volume(const Mesh& mesh) { return meshes::volume(Mesh{mesh.vertices, orient(mesh).triangles}); }

Mesh scrambled(Mesh mesh, std::uint32_t seed) {
  std::mt19937 random(seed);
  for (auto& triangle : mesh.triangles) {
    if (random() % 2) std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

TEST(Orient, MendsScrambledTriangles) {
  const Mesh torus = meshes::torus(1, 0.3, 40, 20);
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    EXPECT_NEAR(oriented_volume(scrambled(torus, seed)), meshes::volume(torus), 1e-12);
    EXPECT_TRUE(orient(scrambled(torus, seed)).closed());
  }
  EXPECT_EQ(orient(torus).triangles, torus.triangles);
  EXPECT_NEAR(oriented_volume(meshes::reversed(torus)), meshes::volume(torus), 1e-12);
}

TEST(Orient, KeepsCavitiesEvenOfReversedSolids) {
  const Mesh outer = meshes::box({0, 0, 0}, {3, 3, 3}), inner = meshes::box({1, 1, 1}, {2, 2, 2});
  const Mesh hollow = meshes::joined(outer, meshes::reversed(inner));
  EXPECT_NEAR(oriented_volume(hollow), 27 - 1, 1e-12);
  EXPECT_NEAR(oriented_volume(meshes::reversed(hollow)), 27 - 1, 1e-12);
  EXPECT_NEAR(oriented_volume(meshes::joined(outer, inner)), 27 + 1, 1e-12);  // a solid in a solid: winding number 2
}

TEST(Orient, KeepsManyCavities) {  // in bearable time, as in scans of porous things
  constexpr int bubbles = 16;
  Mesh sponge = meshes::sphere(6);
  const Mesh bubble = meshes::reversed(meshes::box(Vec3::Zero(), Vec3::Constant(0.02)));
  for (int i = 0; i < bubbles * bubbles * bubbles; ++i) {
    const Vec3 place(i % bubbles, i / bubbles % bubbles, i / bubbles / bubbles);
    sponge = meshes::joined(std::move(sponge), meshes::moved(bubble, Mat3::Identity(), Vec3::Constant(-0.5) + place / bubbles));
  }
  EXPECT_EQ(orient(sponge).components, 1 + std::size_t{bubbles} * bubbles * bubbles);
  EXPECT_NEAR(oriented_volume(sponge), meshes::volume(sponge), 1e-9);
}

TEST(Orient, TurnsReversedSolidsThatAreNotInside) {
  const Mesh a = meshes::box({0, 0, 0}, {2, 2, 2}), beside = meshes::box({5, 0, 0}, {6, 1, 1}), across = meshes::box({1, 1, 1}, {3, 3, 3});
  EXPECT_NEAR(oriented_volume(meshes::joined(a, meshes::reversed(beside))), 8 + 1, 1e-12);
  EXPECT_NEAR(oriented_volume(meshes::joined(a, meshes::reversed(across))), 8 + 8, 1e-12);
}

/// Every triangle with corners of its own, each moved by up to `gap` along every axis.
Mesh soup_of(const Mesh& mesh, double gap) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> moved(-gap, gap);
  Mesh soup;
  for (const auto& triangle : mesh.triangles) {
    const auto n = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t corner : triangle)
      soup.vertices.push_back(mesh.vertices[corner] + Vec3(moved(random), moved(random), moved(random)));
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  return soup;
}

TEST(Orient, ClosesSeamsThatRoundingOpened) {
  const Mesh torus = meshes::torus(1, 0.3, 40, 20);
  for (const double gap : {1e-15, 1e-9, 1e-7, 5e-6}) {
    const OrientedSurface surface = orient(scrambled(soup_of(torus, gap), 1));
    EXPECT_TRUE(surface.closed());
    EXPECT_EQ(surface.components, 1u);
    EXPECT_NEAR(meshes::volume({soup_of(torus, gap).vertices, surface.triangles}), meshes::volume(torus), 10 * gap + 1e-12);
  }
  EXPECT_EQ(orient(soup_of(torus, 1e-3)).components, torus.triangles.size());
}

TEST(Orient, WeldsNoDetail) {  // a torus whose triangles are smaller than gaps may be, open, beside a large box that is open too
  Mesh tiny = meshes::moved(meshes::torus(1, 0.3, 40, 20), 1e-5 * Mat3::Identity(), Vec3::Zero());
  tiny.triangles.pop_back();
  Mesh both = meshes::joined(meshes::box({1, 1, 1}, {2, 2, 2}), tiny);
  both.triangles.erase(both.triangles.begin());
  const OrientedSurface surface = orient(both);
  EXPECT_EQ(surface.triangles, both.triangles);
  EXPECT_EQ(surface.components, 2u);
}

TEST(Orient, JoinsFacesByPosition) {
  Mesh soup;
  const Mesh box = scrambled(meshes::box({0, 0, 0}, {1, 1, 1}), 5);
  for (const auto& triangle : box.triangles) {
    const auto n = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t corner : triangle) soup.vertices.push_back(box.vertices[corner]);
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  EXPECT_NEAR(oriented_volume(soup), 1, 1e-12);
  EXPECT_TRUE(orient(soup).closed());
}

/// Triangles about few vertices, no two with the same corners.
Mesh tangle(std::uint32_t seed) {
  constexpr int vertices = 14;
  std::mt19937 random(seed);
  Mesh mesh;
  for (int i = 0; i < vertices; ++i) mesh.vertices.emplace_back(random() % 100, random() % 100, i);
  std::set<std::set<std::uint32_t>> known;
  const auto drawn = [&] { return static_cast<std::uint32_t>(random() % vertices); };
  for (int i = 0; i < 60; ++i) {
    const std::array<std::uint32_t, 3> t{drawn(), drawn(), drawn()};
    const std::set<std::uint32_t> corners(t.begin(), t.end());
    if (corners.size() == 3 && known.insert(corners).second) mesh.triangles.push_back(t);
  }
  return mesh;
}

struct PlainEdge {
  int forward = 0, back = 0;
  std::vector<std::size_t> triangles;
};

// Sides are sorted by counting: the same edges as a map finds.
TEST(Orient, FindsTheEdgesOfATangle) {
  for (std::uint32_t seed = 1; seed < 20; ++seed) {
    const OrientedSurface surface = orient(tangle(seed));
    std::map<std::pair<std::uint32_t, std::uint32_t>, PlainEdge> edges;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t a = surface.triangles[t][k], b = surface.triangles[t][(k + 1) % 3];
        PlainEdge& edge = edges[std::minmax(a, b)];
        ++(a < b ? edge.forward : edge.back);
        edge.triangles.push_back(t);
      }
    }
    std::vector<std::size_t> piece(surface.triangles.size());
    std::iota(piece.begin(), piece.end(), 0);
    double open = 0;
    for (const auto& [ends, edge] : edges) {
      open += std::abs(edge.forward - edge.back);
      if (edge.triangles.size() != 2) continue;
      const std::size_t joins = piece[edge.triangles[0]], joined = piece[edge.triangles[1]];
      std::replace(piece.begin(), piece.end(), joins, joined);
    }
    EXPECT_EQ(surface.components, std::set<std::size_t>(piece.begin(), piece.end()).size());
    EXPECT_NEAR(surface.open, open / static_cast<double>(3 * surface.triangles.size()), 1e-12);
  }
}

TEST(Orient, KnowsOpenSurfaces) {
  Mesh open = meshes::box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  EXPECT_FALSE(orient(open).closed());
  const Mesh flap = meshes::joined(meshes::box({0, 0, 0}, {1, 1, 1}), Mesh{{{0, 0, 0}, {1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}}});
  EXPECT_FALSE(orient(flap).closed());
}

TEST(Orient, CountsComponentsAndOpenSides) {
  const Mesh box = meshes::box({0, 0, 0}, {1, 1, 1});
  Mesh open = box;
  open.triangles.pop_back();
  const OrientedSurface both = orient(meshes::joined(box, meshes::moved(open, Mat3::Identity(), {3, 0, 0})));
  EXPECT_EQ(both.components, 2u);
  EXPECT_DOUBLE_EQ(both.open, 3.0 / (3 * 23));
  EXPECT_EQ(orient(box).open, 0);
}

TEST(Orient, LeavesOutCopies) {
  const Mesh torus = meshes::torus(1, 0.3, 40, 20);
  Mesh some = torus, both_sides = meshes::joined(torus, meshes::reversed(torus));
  for (std::size_t i = 0; i < 30; ++i) some.triangles.push_back(torus.triangles[i * 7]);
  for (const Mesh& mesh : {some, meshes::joined(torus, torus), both_sides}) {
    EXPECT_EQ(orient(mesh).triangles.size(), torus.triangles.size());
    EXPECT_TRUE(orient(mesh).closed());
    EXPECT_NEAR(oriented_volume(mesh), meshes::volume(torus), 1e-12);
  }
}

TEST(Orient, KeepsBothSidesOfAWall) {  // two boxes share a face, which each has from its own side
  const Mesh row = meshes::joined(meshes::box({0, 0, 0}, {1, 1, 1}), meshes::box({0, 0, 1}, {1, 1, 2}));
  EXPECT_EQ(orient(row).triangles.size(), 24u);
  EXPECT_TRUE(orient(row).closed());
}

TEST(Orient, SolidsThatTouchAtAnEdgeAreClosed) {
  const Mesh touching = meshes::joined(meshes::box({0, 0, 0}, {1, 1, 1}), meshes::box({1, 1, 0}, {2, 2, 1}));
  EXPECT_TRUE(orient(touching).closed());
  EXPECT_NEAR(oriented_volume(touching), 2, 1e-12);
}

}  // namespace
}  // namespace homolog
