// SPDX-License-Identifier: MIT
#include "homolog/shape/mesh.h"

#include <gtest/gtest.h>

#include "homolog/base/errors.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

TEST(BoundingBox, IgnoresVerticesThatNoTriangleUses) {
  Mesh mesh = meshes::box({-1, 2, 3}, {4, 5, 7});
  mesh.vertices.emplace_back(100, 100, 100);
  const Box box = bounding_box(mesh);
  EXPECT_EQ(box.min, Vec3(-1, 2, 3));
  EXPECT_EQ(box.max, Vec3(4, 5, 7));
  EXPECT_DOUBLE_EQ(box.diagonal(), std::sqrt(25 + 9 + 16));
}

TEST(BoundingBox, NeedsATriangle) { EXPECT_THROW(bounding_box(Mesh{{Vec3(1, 2, 3)}, {}}), ShapeError); }

TEST(CheckMesh, RefusesCornersThatAreNotThereOrNotFinite) {
  Mesh mesh = meshes::box({0, 0, 0}, {1, 1, 1});
  EXPECT_NO_THROW(check_mesh(mesh));
  mesh.vertices.push_back(Vec3::Constant(std::nan("")));
  EXPECT_NO_THROW(check_mesh(mesh)) << "no triangle uses it";
  mesh.triangles.push_back({0, 1, 8});
  EXPECT_THROW(check_mesh(mesh), ShapeError);
  mesh.triangles.back()[2] = 50'000'000;
  EXPECT_THROW(check_mesh(mesh), ShapeError);
}

}  // namespace
}  // namespace homolog
