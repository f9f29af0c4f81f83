// SPDX-License-Identifier: MIT
// Point clouds through read_mesh(): XYZ and PLY give the same surface; what does not tell an inside is refused.
#include <gtest/gtest.h>

#include "fixtures/solids.h"
#include "homolog/shape/read_attributes.h"
#include "homolog/shape/read_ply_cloud.h"
#include "homolog/shape/read_xyz.h"
#include "shape/clouds.h"
#include "shape/files.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

using ReadCloud = FileTest;

const std::string header =
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
    "property double x\nproperty double y\nproperty double z\n";

PointCloud capsule() { return clouds::sampled(fixtures::mesh_of(fixtures::capsule({0, 0, 0}, {6, 0, 0}, 1), 60), 500); }

std::string ply(const PointCloud& cloud, const std::string& normal = "n") {
  std::string text = fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n", cloud.points.size());
  for (const std::string axis : {"x", "y", "z"}) text += fmt::format("property double {}\n", axis);
  for (const std::string axis : {"x", "y", "z"}) text += fmt::format("property double {}{}\n", normal, axis);
  return text + "end_header\n" + clouds::xyz(cloud);
}

TEST_F(ReadCloud, EveryFormatGivesTheSameSurface) {
  const PointCloud cloud = capsule();
  const Mesh mesh = read("a.xyz", clouds::xyz(cloud));
  EXPECT_NEAR(meshes::volume(mesh), M_PI * (6 + 4.0 / 3), 0.5);
  for (const auto& [name, content] :
       {std::pair{"b.ply", ply(cloud)}, {"long.ply", ply(cloud, "normal_")}, {"c.txt", "# x y z nx ny nz\n\n" + clouds::xyz(cloud)}}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(read(name, content).vertices, mesh.vertices);
  }
}

TEST_F(ReadCloud, OnlyNamedNormalsOfAPlyCountAndPointsWithoutOneAreLeftOut) {
  const PointCloud cloud = read_ply_cloud(header + "end_header\n0 0 2 255 1 2 3\n0 nan 0 7 4 5 6\n", "a.ply");
  EXPECT_EQ(cloud.points, (std::vector<Vec3>{{1, 2, 3}}));
  EXPECT_EQ(cloud.normals, (std::vector<Vec3>{{0, 0, 2}}));
  EXPECT_TRUE(
      is_ply_cloud(header + "element face 0\nproperty list uchar int vertex_indices\nend_header\n0 0 2 255 1 2 3\n0 0 1 7 4 5 6\n", ""));
  expect_error("a.ply", header + "end_header\n0 0 0 255 1 2 3\n0 nan 0 7 4 5 6\n", "points without normals do not tell an inside");
  expect_error("a.ply", header + "end_header\n0 0 1 255 1 2 3\n0 0 1 7 4 5 inf\n", "not a finite number");
  expect_error("a.ply", header + "property float nx\nend_header\n0 0 1 255 1 2 3 0\n0 0 1 7 4 5 6 0\n", "more than once");
  expect_error("a.ply",
               "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 2 3\n",
               "the file holds no faces, and points without normals");
}

TEST_F(ReadCloud, AnXyzIsReadStrictly) {
  const PointCloud cloud = read_xyz("# a comment\n1 2 +3 0 0 .98\r\n\n4 5 6\t0 0 0\n", "a.xyz");
  EXPECT_EQ(cloud.points, (std::vector<Vec3>{{1, 2, 3}}));
  expect_error("a.xyz", "1 2 3 0 0 1\n1 2 3\n", "a.xyz, line 2: points without normals do not tell an inside");
  expect_error("b.txt", "1 2 3\n", "points without normals");
  expect_error("a.xyz", "1 2 3 0 0 1 255 255 255\n", "six columns x y z nx ny nz with blanks between them, but has 9");
  expect_error("a.xyz", "1 2 3 255 128 0\n", "a normal of length 1, but have the length 285");
  expect_error("a.xyz", "1 2 3 0 0 0\n", "points without normals");
  expect_error("a.xyz", "1 2 nan 0 0 1\n", "'nan' is not a finite number");
  expect_error("a.xyz", "1 2 3 0 0 1e999\n", "is not a finite number");
  expect_error("a.xyz", "1;2;3;0;0;1\n", "with blanks between them, but has 1");
  expect_error("a.xyz", "3\n1 2 3 0 0 1\n", "line 2: 3 points are announced in the first line, but 1 follow");
  expect_error("a.txt", "x y z nx ny nz\n", "is not known");
}

TEST_F(ReadCloud, AnXyzMayBeginWithACountOrTheNamesOfColumns) {
  for (const char* head : {"", "2\n", " 2 \r\n", "//X Y Z Nx Ny Nz\n", "//X Y Z Nx Ny Nz\n2\n"}) {
    const std::string text = std::string(head) + "1 2 3 0 0 1\n4 5 6 0 0 0\n";
    EXPECT_TRUE(is_xyz(text)) << head;
    EXPECT_EQ(read_xyz(text, "a.xyz").points, (std::vector<Vec3>{{1, 2, 3}})) << head;
  }
  EXPECT_FALSE(is_xyz("99999999999999999999\n1 2 3\n"));
}

TEST_F(ReadCloud, MorePointsThanAllowedAreRefused) {
  const std::filesystem::path path = write("a.xyz", "0 0 0 0 0 -1\n0 0 1 0 0 1\n");
  EXPECT_THROW(read_mesh(path, {most_bytes, 1, 1}), FileError);
}

TEST_F(ReadCloud, WhatIsPaintedOnPointsIsNotTakenForWhatIsPaintedOnAMesh) {
  const PointCloud cloud = capsule();
  EXPECT_THROW(read_attributes(write("a.ply", ply(cloud))), FileError);
}

}  // namespace
}  // namespace homolog
