// SPDX-License-Identifier: MIT
#include "homolog/shape/cluster_vertices.h"

#include <gtest/gtest.h>

#include "shape/meshes.h"

namespace homolog {
namespace {

TEST(ClusterVertices, AreMeansOfWhatLiesInACell) {
  const Mesh mesh{{{0, 0, 0}, {0.2, 0, 0}, {5, 0, 0}, {0, 5, 0}, {9, 9, 9}}, {{0, 2, 3}, {1, 2, 3}, {0, 1, 3}}};
  const ClusteredMesh clustered = cluster_vertices(mesh, 1);
  EXPECT_EQ(clustered.mesh.vertices, (std::vector<Vec3>{{0.1, 0, 0}, {5, 0, 0}, {0, 5, 0}}));
  EXPECT_EQ(clustered.mesh.triangles.size(), 2u);  // the third one has collapsed
  EXPECT_EQ(clustered.cluster, (std::vector<std::uint32_t>{0, 0, 1, 2, ClusteredMesh::nowhere}));
}

TEST(ClusterVertices, OfAPlatesTwoSidesJoinUnlessNormalsKeepThemApart) {
  const Mesh plate = meshes::box({0, 0, 0}, {8, 8, 0.01});
  EXPECT_EQ(cluster_vertices(plate, 1).mesh.vertices.size(), 4u);
  std::vector<Vec3> normals;
  for (const Vec3& v : plate.vertices) normals.emplace_back(0, 0, v.z() > 0 ? 1 : -1);
  const ClusteredMesh clustered = cluster_vertices(plate, 1, normals);
  ASSERT_EQ(clustered.mesh.vertices.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(clustered.mesh.vertices[clustered.cluster[i]], plate.vertices[i]);
}

}  // namespace
}  // namespace homolog
