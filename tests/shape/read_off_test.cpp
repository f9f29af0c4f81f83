// SPDX-License-Identifier: MIT
#include "homolog/shape/read_off.h"

#include "shape/files.h"

namespace homolog {
namespace {

const std::string tetrahedron = "OFF\n5 4 6\n0 0 0\n9 9 9\n1 0 0\n0 1 0\n0 0 1\n3 0 3 2\n3 0 2 4\n3 0 4 3\n3 2 3 4\n";

using ReadOff = FileTest;

TEST_F(ReadOff, KeepsOrderCountAndDigitsOfVertices) {
  const Mesh mesh = read("a.off", "OFF\n5 2 0\n0.1234567890123 0 0\n9 9 9\n1 0 0\n0 1 0\n1 0 0\n3 4 3 0\n4 0 2 3 1\n");
  EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{{0.1234567890123, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}}));
  EXPECT_EQ(mesh.triangles.front(), (std::array<std::uint32_t, 3>{4, 3, 0}));
  EXPECT_EQ(mesh.triangles.size(), 3u);
}

TEST_F(ReadOff, KnowsTheFormatsVariants) {
  EXPECT_EQ(read("a.off", tetrahedron).triangles.size(), 4u);
  EXPECT_EQ(read("a.OFF", "# made by hand\r\nOFF 3 1 0\r\n\r\n0 0 0 # first\r\n1 0 0\r\n0 1 0\r\n3 0 1 2 255 0 0\r\n").triangles.size(),
            1u);
  EXPECT_EQ(read("a.off", "3 1 0\n0 0 0\n+1e0 0 0\n0 1 0\n3 0 1 2").triangles.size(), 1u);
  const Mesh coloured = read("a.off", "COFF\n3 2\n0 0 0 1 1 1 1\n1 0 0 .5 0 0 1\n0 1 0 0 0 0 1\n3 0 1 2\n2 0 1\n");
  EXPECT_EQ(coloured.vertices[1], Vec3(1, 0, 0));
  EXPECT_EQ(coloured.triangles.size(), 1u);
}

TEST_F(ReadOff, RefusesDamagedFiles) {
  expect_error("a.off", "OFF\n3\n1\n0\n0\n0\n0\n", "line 2: the numbers of vertices and faces must stand in one line");
  expect_error("a.off", "# nothing\n", "empty");
  expect_error("a.off", tetrahedron + "3 0 1 2\n", "faces are announced, but the file goes on after them");
  expect_error("a.off", "OFF\n3 1 0\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n", "not every vertex has a line of its own");
  expect_error("a.off", "OFF\n", "ends before");
  expect_error("a.off", "OFF BINARY\n1 2 3\n", "binary");
  expect_error("a.off", "4OFF\n1 0 0\n0 0 0 0\n", "not supported");
  expect_error("a.off", "solid x\n", "not a whole number");
  expect_error("a.off", "OFF\n-3 1 0\n0 0 0\n", "-3 vertices");
  expect_error("a.off", "OFF\n4000000000 1 0\n0 0 0\n", "too short");
  expect_error("a.off", "OFF\n3 999999999999 0\n0 0 0\n", "too short");
  expect_error("a.off", "OFF\n99999999999999999999 1 0\n0 0 0\n", "not a whole number");
  expect_error("a.off", "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "line 4: a vertex coordinate is missing");
  expect_error("a.off", "OFF\n3 1 0\n0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n", "line 4: 'x' is not a finite number");
  expect_error("a.off", "OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n", "line 4: 'nan' is not a finite number");
  expect_error("a.off", "OFF\n3 1 0\n0 0 0\n1 0 1e999\n0 1 0\n3 0 1 2\n", "line 4: '1e999' is not a finite number");
  expect_error("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 6: vertex 3 does not exist");
  expect_error("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "line 6: vertex -1 does not exist");
  expect_error("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "line 6: a face of 3 corners does not fit its line");
  expect_error("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3000000000 0 1 2\n", "line 6: a face of 3000000000 corners");
  expect_error("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", "no triangles");
  for (const std::size_t length : {20u, 30u, 45u, 60u}) expect_error("a.off", tetrahedron.substr(0, length), "truncated");
}

}  // namespace
}  // namespace homolog
