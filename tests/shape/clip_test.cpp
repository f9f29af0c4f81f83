// SPDX-License-Identifier: MIT
#include "homolog/shape/clip.h"

#include <gtest/gtest.h>

#include "shape/meshes.h"

namespace homolog {
namespace {

void expect_bounds(const Mesh& mesh, const Box& box, const Box& expected) {
  const Box bounds = clipped_bounding_box(mesh.vertices, mesh.triangles, box);
  EXPECT_TRUE(bounds.min.isApprox(expected.min, 1e-12)) << bounds.min.transpose();
  EXPECT_TRUE(bounds.max.isApprox(expected.max, 1e-12)) << bounds.max.transpose();
}

TEST(Clip, BoundsTheSurfaceInTheBox) {
  const Mesh tetrahedron{{{1, 1, 1}, {5, 1, 1}, {1, 5, 1}, {1, 1, 5}}, {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
  expect_bounds(tetrahedron, {{0, 0, 0}, {9, 9, 9}}, {{1, 1, 1}, {5, 5, 5}});
  expect_bounds(tetrahedron, {{3, 0, 0}, {9, 9, 9}}, {{3, 1, 1}, {5, 3, 3}});
  expect_bounds(tetrahedron, {{0, 0, 2}, {9, 9, 4}}, {{1, 1, 2}, {4, 4, 4}});
}

TEST(Clip, BoundsTheSolidWhereItFillsTheBox) {
  const Mesh cube = meshes::box({0, 0, 0}, {3, 3, 3});
  expect_bounds(cube, {{1, 1, 1}, {2, 2, 2}}, {{1, 1, 1}, {2, 2, 2}});
  expect_bounds(cube, {{1, 1, 1}, {2, 2, 8}}, {{1, 1, 1}, {2, 2, 3}});
}

TEST(Clip, IsEmptyOutside) {
  const Mesh cube = meshes::box({0, 0, 0}, {3, 3, 3});
  EXPECT_TRUE((clipped_bounding_box(cube.vertices, cube.triangles, {{4, 4, 4}, {5, 5, 5}}).max.array() < 0).all());
}

}  // namespace
}  // namespace homolog
