// SPDX-License-Identifier: MIT
#include "homolog/outputs/ply.h"

#include <gtest/gtest.h>

#include "homolog/shape/read_ply.h"

namespace homolog {
namespace {

const Mesh triangle{{{0, 0, 0.1}, {1.0 / 3, 0, 1e-300}, {0, -2e17, 0}}, {{0, 1, 2}}};

TEST(PlyText, IsAHeaderThenVerticesThenTriangles) {
  EXPECT_EQ(ply_text(triangle, {{1, 2, 3}, {0, 0, 0}, {255, 255, 255}}, {{"quality", {0, 0.5, 1}}}, "hello"),
            "ply\nformat ascii 1.0\ncomment hello\nelement vertex 3\n"
            "property double x\nproperty double y\nproperty double z\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float quality\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0.1 1 2 3 0\n0.3333333333333333 0 1e-300 0 0 0 0.5\n0 -2e+17 0 255 255 255 1\n3 0 1 2\n");
}

TEST(PlyText, IsReadBackToTheLastBit) {
  const Mesh back = read_ply(ply_text(triangle, {}, {{"a", {1, 2, 3}}, {"b", {4, 5, 6}}}, "two columns"), "own.ply");
  EXPECT_EQ(back.vertices, triangle.vertices);
  EXPECT_EQ(back.triangles, triangle.triangles);
}

}  // namespace
}  // namespace homolog
