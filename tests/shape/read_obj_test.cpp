// SPDX-License-Identifier: MIT
#include "homolog/shape/read_obj.h"

#include "shape/files.h"

namespace homolog {
namespace {

using ReadObj = FileTest;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

TEST_F(ReadObj, KeepsTheVLinesWhateverTheFacesUse) {
  const Mesh mesh = read(
      "a.obj",
      "mtllib x.mtl\no thing\nv 9 9 9\nv 0.1234567890123 0 0 1.0\nvn 0 0 1\nvt 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\ng part\nusemtl m\ns off\n"
      "f 5/1/1 4/1/1 3/1/1\nf 2//1 3//1 4//1\nl 1 2\np 1\n");
  EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{{9, 9, 9}, {0.1234567890123, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{4, 3, 2}, {1, 2, 3}}));
}

TEST_F(ReadObj, ReadsRelativeLaterAndContinuedNumbers) {
  EXPECT_EQ(read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\n").triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(read("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(read("a.OBJ", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 \\\r\n2 \\\r\n3\r\n").triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(read("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4 # quad\n").triangles.size(), 2u);
}

TEST_F(ReadObj, KnowsNamesThatEndInABackslash) {
  const std::string faces = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const char* line : {"mtllib C:\\dir\\", "usemtl a\\", "o a\\", "g a b\\"}) {
    EXPECT_EQ(read("a.obj", line + ("\n" + faces)).vertices.size(), 3u) << line;
    EXPECT_EQ(read("a.obj", line + ("\r\n" + faces)).vertices.size(), 3u) << line;
  }
  EXPECT_EQ(read("a.obj", "g a \\\nb\n" + faces).vertices.size(), 3u);
  EXPECT_EQ(read("a.obj", "g a \\\nv 9 9 9\n" + faces).vertices.size(), 3u) << "a line that goes on";
  EXPECT_EQ(read("a.obj", "v 0 0\\\n0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").vertices.size(), 3u) << "numbers are no names";
}

TEST_F(ReadObj, TellsThatFreeFormSurfacesAreLeftOut) {
  const std::string polygons = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\n";
  const std::string surface = "cstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nparm u 0 1\nparm v 0 1\nend\n";
  EXPECT_EQ(told("a.obj", polygons), "");
  EXPECT_EQ(told("a.obj", polygons + surface),
            "1 free-form surface (surf) is left out; make polygons of what is missing and export it again\n");
  EXPECT_NE(told("a.obj", polygons + surface + surface).find("2 free-form surfaces (surf) are left out"), std::string::npos);
  EXPECT_EQ(read("a.obj", polygons + surface).triangles.size(), 1u) << "and nobody need listen";
}

TEST_F(ReadObj, RefusesDamagedFiles) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  expect_error("a.obj", vertices, "no triangles");
  expect_error("a.obj", vertices + "f 1 2 4\n", "line 4: vertex 4 does not exist (the file has 3)");
  expect_error("a.obj", vertices + "f 1 2 0\n", "line 4: vertex 0 does not exist");
  expect_error("a.obj", vertices + "f 1 2 -4\n", "line 4: vertex -4 does not exist");
  expect_error("a.obj", vertices + "f 1 2 99999999999\n", "line 4: vertex 99999999999 does not exist");
  expect_error("a.obj", vertices + "f 1 2 x\n", "line 4: 'x' is not a whole number");
  expect_error("a.obj", vertices + "f 1 2 /3\n", "line 4: the vertex number of a face is missing");
  expect_error("a.obj", vertices + "v 0 0\nf 1 2 3\n", "line 4: a vertex coordinate is missing");
  expect_error("a.obj", vertices + "v 0 0 inf\nf 1 2 3\n", "line 4: 'inf' is not a finite number");
}

}  // namespace
}  // namespace homolog
