// SPDX-License-Identifier: MIT
#include "homolog/shape/weld.h"

#include <gtest/gtest.h>

namespace homolog {
namespace {

TEST(Weld, JoinsEqualPositionsInOrderOfFirstOccurrence) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, -0.0}}, {{0, 1, 2}, {3, 4, 5}, {1, 3, 4}}};
  const Mesh welded = weld(mesh);
  EXPECT_EQ(welded.vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(welded.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {1, 3, 2}}));
}

TEST(Weld, KeepsVerticesThatAreOnlyNear) {
  EXPECT_EQ(first_equal_vertex({{0, 0, 0}, {1e-300, 0, 0}, {0, 0, 0}}), (std::vector<std::uint32_t>{0, 1, 0}));
}

}  // namespace
}  // namespace homolog
