// SPDX-License-Identifier: MIT
#include "homolog/match/dense_faults.h"

#include <gtest/gtest.h>

#include "homolog/shape/vertex_normals.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

/// Every vertex at itself.
Places own_places(const Mesh& mesh) {
  Places places(mesh.vertices.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangles[t][k];
      places[vertex] = SurfacePlace{t, Vec3::Unit(k), mesh.vertices[vertex], 0};
    }
  }
  return places;
}

const Mesh sphere = meshes::sphere(3);

TEST(EdgesOf, AreThoseOfEuler) {
  const Mesh torus = meshes::torus(1, 0.3, 12, 8);
  EXPECT_EQ(edges_of(torus).size(), torus.vertices.size() + torus.triangles.size());
}

TEST(TakeTornApart, LeavesWhatHoldsTogether) {
  Places places = own_places(sphere);
  EXPECT_EQ(take_torn_apart(places, sphere, edges_of(sphere), SkinRoutes(sphere), {2, 0}), 0u);
  for (const auto& place : places) EXPECT_TRUE(place);
}

TEST(TakeTornApart, TakesTheVertexThatLiesElsewhere) {
  Places places = own_places(sphere);
  const auto edges = edges_of(sphere);
  const auto neighbours = std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge[0] == 0 || edge[1] == 0; });
  places[0] = places[1];  // the other pole
  EXPECT_EQ(take_torn_apart(places, sphere, edges, SkinRoutes(sphere), {2, 0}), static_cast<std::size_t>(neighbours));
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(places[i].has_value(), i != 0);
}

TEST(CountFolds, SeesNoneInTheIdentityAndAllInAWrongHand) {
  const std::vector<Vec3> normals = vertex_normals(sphere);
  const Folds proper = count_folds(sphere.triangles, own_places(sphere), sphere, normals, false);
  EXPECT_EQ(proper.triangles, sphere.triangles.size());
  EXPECT_EQ(proper.folded, 0u);
  EXPECT_EQ(count_folds(sphere.triangles, own_places(sphere), sphere, normals, true).folded, sphere.triangles.size());
}

TEST(CountFolds, SeesAVertexPulledOverItsNeighbours) {
  Places places = own_places(sphere);
  std::size_t far = 0;  // two rings away from vertex 0, which lies at x = 1
  for (std::size_t i = 0; i < sphere.vertices.size(); ++i) {
    if (sphere.vertices[i].x() > 0.7 && sphere.vertices[i].x() < sphere.vertices[far].x()) far = i;
  }
  places[0] = places[far];
  const Folds folds = count_folds(sphere.triangles, places, sphere, vertex_normals(sphere), false);
  EXPECT_GT(folds.folded, 0u);
  EXPECT_LE(folds.folded, 4u);  // of the four triangles about it
}

}  // namespace
}  // namespace homolog
