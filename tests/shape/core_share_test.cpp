// SPDX-License-Identifier: MIT
#include "homolog/shape/core_share.h"

#include <gmock/gmock.h>

#include "homolog/base/errors.h"
#include "homolog/shape/voxelize.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// With a triangle of `size` whose first corner lies at x.
Mesh with_stray(Mesh mesh, const Vec3& x, double size) {
  const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(size, 0, 0), Vec3(0, size, 0)}) mesh.vertices.push_back(x + corner);
  mesh.triangles.push_back({n, n + 1, n + 2});
  return mesh;
}

TEST(CoreShare, OfAWholeIsNearlyOne) {
  EXPECT_GT(core_share(meshes::sphere(4)), 0.95);
  EXPECT_THAT(told_core(meshes::sphere(4)), IsEmpty());
}

TEST(CoreShare, IsWhatIsLeftWithoutAStrayTriangle) {
  const Mesh ball = meshes::sphere(4);  // of radius 1
  for (const double far : {9.0, 99.0}) {
    EXPECT_NEAR(core_share(with_stray(ball, Vec3::Constant(far), 0.01)), 2 / (far + 1), 0.003) << far;
  }
  EXPECT_THAT(told_core(with_stray(ball, Vec3::Constant(99), 0.01)), HasSubstr("97 % of its surface lie within 2"));
}

TEST(CoreShare, IsAskedOfTheAreaAndNotOfTheTriangles) { EXPECT_GT(core_share(with_stray(meshes::sphere(4), Vec3::Constant(9), 1)), 0.9); }

TEST(CoreShare, OfOneTriangleIsOne) { EXPECT_GT(core_share({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}}), 0.99); }

TEST(CoreShare, OfNoAreaIsOne) { EXPECT_EQ(core_share({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}, {{0, 1, 2}}}), 1); }

TEST(CoreShare, IsToldWhereTheRestIsTooSmallToHaveAnInside) {
  const Mesh far = with_stray(meshes::sphere(4), Vec3::Constant(1e6), 0.01);
  EXPECT_THAT([&] { voxelize(far, 64); },
              testing::ThrowsMessage<ShapeError>(HasSubstr("too small for its box to have an inside: 97 % of its surface")));
}

}  // namespace
}  // namespace homolog
