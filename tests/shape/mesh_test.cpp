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

}  // namespace
}  // namespace homolog
