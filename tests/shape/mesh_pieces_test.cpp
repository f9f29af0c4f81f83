// SPDX-License-Identifier: MIT
#include "homolog/shape/mesh_pieces.h"

#include <gtest/gtest.h>

#include "shape/meshes.h"

namespace homolog {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

TEST(MeshPieces, KeptTrianglesBringTheirVerticesAlong) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}, {{4, 3, 1}, {0, 1, 3}}};
  const Mesh left = kept_triangles(mesh, {0, 1, 1, 1, 1});
  EXPECT_EQ(left.vertices, (std::vector<Vec3>{{1, 0, 0}, {3, 0, 0}, {4, 0, 0}}));
  EXPECT_EQ(left.triangles, (Triangles{{2, 1, 0}}));
}

TEST(MeshPieces, SpecksAreLeftOutAndLargePiecesNot) {
  const Mesh small = meshes::box({5, 5, 5}, {6, 6, 6}), large = meshes::sphere(2);
  const Mesh left = without_specks(meshes::joined(small, large), 13);
  EXPECT_EQ(left.vertices, large.vertices);
  EXPECT_EQ(left.triangles, large.triangles);
  EXPECT_EQ(without_specks(meshes::joined(small, large), 12).triangles.size(), large.triangles.size() + 12);
}

}  // namespace
}  // namespace homolog
