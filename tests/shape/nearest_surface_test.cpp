// SPDX-License-Identifier: MIT
#include "homolog/shape/nearest_surface.h"

#include <gtest/gtest.h>

#include "fixtures/solids.h"
#include "homolog/shape/vertex_normals.h"

namespace homolog {
namespace {

NearestSurface surface_of(const Mesh& mesh) { return {mesh, vertex_normals(mesh)}; }

TEST(NearestOnTriangle, IsTheFootOrOnTheNearestEdgeOrCorner) {
  const Vec3 a(0, 0, 0), b(2, 0, 0), c(0, 2, 0);
  EXPECT_TRUE(nearest_on_triangle(a, b, c, {0.5, 0.5, 3}).isApprox(Vec3(0.5, 0.25, 0.25)));
  EXPECT_TRUE(nearest_on_triangle(a, b, c, {1, -1, 1}).isApprox(Vec3(0.5, 0.5, 0)));
  EXPECT_TRUE(nearest_on_triangle(a, b, c, {5, -1, 0}).isApprox(Vec3(0, 1, 0)));
  EXPECT_TRUE(nearest_on_triangle(a, b, c, {2, 2, 0}).isApprox(Vec3(0, 0.5, 0.5)));
}

TEST(NearestOnTriangle, WithoutAreaIsOnItsEdges) {
  const Vec3 shares = nearest_on_triangle({0, 0, 0}, {1, 0, 0}, {4, 0, 0}, {3, 1, 0});
  EXPECT_NEAR(shares.sum(), 1, 1e-12);
  EXPECT_NEAR(shares[1] + 4 * shares[2], 3, 1e-12);
  EXPECT_TRUE(nearest_on_triangle({1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {3, 1, 0}).isApprox(Vec3(1, 0, 0)));
}

TEST(NearestSurface, AgreesWithLookingAtEveryTriangle) {
  const Mesh mesh = fixtures::mesh_of(fixtures::quadruped(), 24);
  const NearestSurface surface = surface_of(mesh);
  for (int i = 0; i < 200; ++i) {
    const Vec3 x = fixtures::random_rotation(i) * Vec3(1.5 * i / 200, 0.1, 0.3);
    double least = 1e9;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
      const Vec3 shares = nearest_on_triangle(p, q, r, x);
      least = std::min(least, (shares[0] * p + shares[1] * q + shares[2] * r - x).norm());
    }
    const auto place = surface.nearest(x, Vec3::Zero(), 100);
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->distance, least, 1e-12);
    EXPECT_NEAR((place->position - x).norm(), least, 1e-12);
    EXPECT_FALSE(surface.nearest(x, Vec3::Zero(), 0.99 * least));
    EXPECT_EQ(surface.nearest(x, Vec3::Zero(), 100, 7 * i)->distance, place->distance) << "wherever it is looked first";
  }
}

TEST(NearestSurface, FindsTheSideThatFacesTheSameWay) {
  const Mesh mesh = fixtures::mesh_of(fixtures::box({0, 0, 0}, {1, 1, 0.05}), 40);
  const NearestSurface surface = surface_of(mesh);
  const auto below = surface.nearest({0.1, 0.2, 0.04}, -Vec3::UnitZ(), 1);
  ASSERT_TRUE(below);
  EXPECT_NEAR(below->position.z(), -0.05, 1e-9);
  EXPECT_NEAR(surface.nearest({0.1, 0.2, -0.04}, Vec3::UnitZ(), 1)->position.z(), 0.05, 1e-9);
  EXPECT_FALSE(surface.nearest({0.1, 0.2, 0.04}, -Vec3::UnitZ(), 0.05));
}

// The least distance to a triangle whose nearest place agrees with `normal`, looking at all of them.
double least_distance(const Mesh& mesh, const std::vector<Vec3>& normals, const Vec3& x, const Vec3& normal) {
  double least = 1e9;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 shares = nearest_on_triangle(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], x);
    const Vec3 own = shares[0] * normals[a] + shares[1] * normals[b] + shares[2] * normals[c];
    const Vec3 place = shares[0] * mesh.vertices[a] + shares[1] * mesh.vertices[b] + shares[2] * mesh.vertices[c];
    if (own.dot(normal) >= 0.5 * own.norm() * normal.norm()) least = std::min(least, (place - x).norm());
  }
  return least;
}

TEST(NearestSurface, PassesNoPlaceThatAgreesWithANormal) {
  Mesh mesh = fixtures::mesh_of(fixtures::hand(), 30);
  NearestSurface surface = surface_of(mesh);
  for (const double stretch : {1.0, 1.7}) {  // where it was made, and moved
    for (Vec3& vertex : mesh.vertices) vertex.x() *= stretch;
    const std::vector<Vec3> normals = vertex_normals(mesh);
    surface.move(mesh.vertices, normals);
    for (int i = 0; i < 200; ++i) {
      const Vec3 x = mesh.vertices[static_cast<std::size_t>(37 * i) % mesh.vertices.size()] + 0.1 * fixtures::random_rotation(i).col(0);
      const Vec3 normal = fixtures::random_rotation(i).col(1);
      const auto place = surface.nearest(x, normal, 100, static_cast<std::uint32_t>(i));
      ASSERT_TRUE(place);
      EXPECT_NEAR(place->distance, least_distance(mesh, normals, x, normal), 1e-9) << i;
    }
  }
}

TEST(EightTriangles, AgreeWithOneAfterTheOther) {
  const Vec3 shapes[][3] = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},    {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}}, {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}},
                            {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}},    {{0, 0, 0}, {5, 0, 1}, {0, 0.1, 0}},    {{1, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                            {{-1, -1, 2}, {1, -1, 2}, {0, 2, 2}}, {{-3, 0, 0}, {3, 0, 0}, {0, 0, 4}}};
  EightTriangles triangles;
  for (std::size_t i = 0; i < triangles_at_once; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (int k = 0; k < 3; ++k) triangles.corners[c][static_cast<std::size_t>(k)][i] = shapes[i][c][k];
    }
  }
  for (int trial = 0; trial < 500; ++trial) {
    const Vec3 x = fixtures::random_rotation(trial).col(0) * (0.01 * trial);
    const EightPlaces places = nearest_places(triangles, x);
    for (std::size_t i = 0; i < triangles_at_once; ++i) {
      const auto place = [&](double a, double b, double c) -> Vec3 { return a * shapes[i][0] + b * shapes[i][1] + c * shapes[i][2]; };
      const Vec3 one = nearest_on_triangle(shapes[i][0], shapes[i][1], shapes[i][2], x);
      const double distance = std::sqrt(places.square_distance[i]);
      EXPECT_NEAR(distance, (place(one[0], one[1], one[2]) - x).norm(), 1e-7) << i;
      EXPECT_NEAR((place(places.barycentric[0][i], places.barycentric[1][i], places.barycentric[2][i]) - x).norm(), distance, 1e-7) << i;
      EXPECT_NEAR(places.barycentric[0][i] + places.barycentric[1][i] + places.barycentric[2][i], 1, 1e-9) << i;
    }
  }
}

TEST(NearestSurface, OfNothingIsNowhere) { EXPECT_FALSE(surface_of({}).nearest(Vec3::Zero(), Vec3::Zero(), 1e9)); }

TEST(VertexNormals, OfABallPointFromItsCentreHoweverItsTrianglesTurn) {
  Mesh mesh = fixtures::mesh_of(fixtures::ball({1, 2, 3}, 0.5), 16);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
  mesh.vertices.push_back({7, 7, 7});
  const std::vector<Vec3> normals = vertex_normals(mesh);
  for (std::size_t i = 0; i + 1 < normals.size(); ++i) {
    EXPECT_GT(normals[i].dot((mesh.vertices[i] - Vec3(1, 2, 3)).normalized()), 0.98);
    EXPECT_NEAR(normals[i].norm(), 1, 1e-12);
  }
  EXPECT_EQ(normals.back(), Vec3::Zero());
}

}  // namespace
}  // namespace homolog
