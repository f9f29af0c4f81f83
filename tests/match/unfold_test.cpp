// SPDX-License-Identifier: MIT
#include "homolog/match/unfold.h"

#include <gtest/gtest.h>

#include "homolog/shape/vertex_normals.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

/// A sphere on itself, every vertex at itself.
struct OnItself {
  Mesh mesh;
  std::vector<Vec3> normals = oriented_normals(mesh);
  NearestSurface surface{mesh, normals};
  Places places = Places(mesh.vertices.size());

  explicit OnItself(Mesh sphere = meshes::sphere(4)) : mesh(std::move(sphere)) {
    for (std::size_t i = 0; i < places.size(); ++i) lay(i, mesh.vertices[i]);
  }
  void lay(std::size_t vertex, const Vec3& x) { places[vertex] = surface.nearest(x, Vec3::Zero(), 9); }
  LaidMesh laid() const { return {mesh, normals, surface, mesh, normals, false}; }
  std::size_t folded(bool mirrored = false) const { return count_folds(mesh.triangles, places, mesh, normals, mirrored).folded; }

  /// Vertex 0 across the far side of a triangle that it is a corner of.
  void fold() {
    const auto triangle =
        std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [](const auto& t) { return t[0] == 0 || t[1] == 0 || t[2] == 0; });
    Vec3 opposite = -mesh.vertices[0];
    for (const std::uint32_t corner : *triangle) opposite += mesh.vertices[corner];
    lay(0, opposite - 0.5 * mesh.vertices[0]);
  }
};

TEST(Unfold, LaysAFoldedVertexBetweenItsNeighbours) {
  OnItself sphere;
  ASSERT_EQ(sphere.folded(), 0u);
  sphere.fold();
  ASSERT_GT(sphere.folded(), 0u);
  unfold(sphere.places, sphere.laid(), 1);
  EXPECT_EQ(sphere.folded(), 0u);
  for (std::size_t i = 0; i < sphere.places.size(); ++i) {
    EXPECT_NEAR(sphere.surface.nearest(sphere.places[i]->position, Vec3::Zero(), 9)->distance, 0, 1e-12) << "on the surface";
    EXPECT_LT((sphere.places[i]->position - sphere.mesh.vertices[i]).norm(), 0.2);
  }
}

TEST(Unfold, LeavesWhatIsNotFoldedAndMovesNothingTooFar) {
  OnItself sphere;
  const Vec3 middle = sphere.mesh.vertices[3];
  unfold(sphere.places, sphere.laid(), 1);
  EXPECT_LT((sphere.places[3]->position - middle).norm(), 1e-12);
  sphere.fold();
  const Vec3 before = sphere.places[0]->position;
  const std::size_t folded = sphere.folded();
  unfold(sphere.places, sphere.laid(), 0.01);
  EXPECT_LT((sphere.places[0]->position - before).norm(), 0.01);
  EXPECT_LE(sphere.folded(), folded);
}

TEST(Unfold, KnowsMirroredMaps) {
  OnItself sphere;
  for (std::size_t i = 0; i < sphere.places.size(); ++i) sphere.lay(i, Vec3(-1, 1, 1).cwiseProduct(sphere.mesh.vertices[i]));
  std::vector<Vec3> facing;
  for (const Vec3& normal : sphere.normals) facing.push_back(Vec3(-1, 1, 1).cwiseProduct(normal));
  const LaidMesh laid{sphere.mesh, facing, sphere.surface, sphere.mesh, sphere.normals, true};
  ASSERT_EQ(sphere.folded(true), 0u);
  const auto neighbour = sphere.mesh.triangles[0];
  sphere.lay(neighbour[0], 2 * sphere.places[neighbour[1]]->position - sphere.places[neighbour[0]]->position);
  ASSERT_GT(sphere.folded(true), 0u);
  unfold(sphere.places, laid, 1);
  EXPECT_EQ(sphere.folded(true), 0u);
}

TEST(Unfold, LeavesPlacesThatAreMissingMissing) {
  OnItself sphere;
  sphere.fold();
  sphere.places[7].reset();
  unfold(sphere.places, sphere.laid(), 1);
  EXPECT_FALSE(sphere.places[7]);
  EXPECT_EQ(sphere.folded(), 0u);
}

TEST(Unfold, VerticesInOnePlaceStayThere) {
  Mesh cut = meshes::sphere(4);
  const auto copy = static_cast<std::uint32_t>(cut.vertices.size());
  cut.vertices.push_back(cut.vertices[0]);
  auto triangle =
      std::find_if(cut.triangles.begin(), cut.triangles.end(), [](const auto& t) { return t[0] == 0 || t[1] == 0 || t[2] == 0; });
  std::replace(triangle->begin(), triangle->end(), std::uint32_t{0}, copy);
  OnItself sphere(cut);
  const Vec3 wrong = 2 * sphere.mesh.vertices[(*triangle)[0] == copy ? (*triangle)[1] : (*triangle)[0]] - sphere.mesh.vertices[0];
  sphere.lay(0, wrong);
  sphere.lay(copy, wrong);
  unfold(sphere.places, sphere.laid(), 1);
  EXPECT_EQ(sphere.places[0]->position, sphere.places[copy]->position);
  EXPECT_EQ(sphere.folded(), 0u);
}

}  // namespace
}  // namespace homolog
