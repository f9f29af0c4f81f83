// SPDX-License-Identifier: MIT
#include "homolog/shape/read_ply_attributes.h"

#include <gmock/gmock.h>

#include <cmath>

#include "homolog/shape/read_attributes.h"
#include "shape/files.h"

namespace homolog {
namespace {

using testing::HasSubstr;
using ReadAttributes = FileTest;

std::string ply(const std::string& properties, const std::string& vertices) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" + properties +
         "element face 1\nproperty list uchar int vertex_indices\nend_header\n" + vertices + "3 0 1 2\n";
}

TEST(ReadPlyAttributes, TakesColoursLabelsAndValuesByTheirTypes) {
  const AttributedMesh mesh = read_ply_attributes(ply("property float nx\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                                                      "property short part\nproperty double depth\nproperty list uchar int near\n",
                                                      "0 0 0 nan 255 51 0 -7 1.5 1 2\n1 0 0 0 0 0 255 3 nan 0\n0 1 0 0 0 0 0 3 1e300 0\n"),
                                                  "a.ply");
  EXPECT_EQ(mesh.mesh.triangles.size(), 1u);
  ASSERT_EQ(mesh.colours.size(), 3u);
  EXPECT_EQ(mesh.colours[0], (Rgba{1, 0.2f, 0, 1}));
  ASSERT_EQ(mesh.fields.size(), 2u);
  EXPECT_EQ(mesh.fields[0].name, "part");
  EXPECT_EQ(mesh.fields[0].kind, Field::Kind::label);
  EXPECT_EQ(mesh.fields[0].values, (std::vector<double>{-7, 3, 3}));
  EXPECT_EQ(mesh.fields[1].kind, Field::Kind::value);
  EXPECT_EQ(mesh.fields[1].values[0], 1.5);
  EXPECT_TRUE(std::isnan(mesh.fields[1].values[1]));
  EXPECT_EQ(told_attributes(mesh), "colours, labels part, values depth");
}

TEST(ReadPlyAttributes, TakesColoursOfAllTypesAndAlpha) {
  const AttributedMesh mesh =
      read_ply_attributes(ply("property float red\nproperty ushort green\nproperty uchar blue\nproperty uchar alpha\n",
                              "0 0 0 .5 65535 0 51\n1 0 0 2 0 0 0\n0 1 0 0 0 0 255\n"),
                          "a.ply");
  EXPECT_EQ(mesh.colours[0], (Rgba{0.5f, 1, 0, 0.2f}));
  EXPECT_EQ(mesh.colours[1][0], 1) << "no more than all";
  EXPECT_EQ(mesh.colours[2][3], 1);
}

TEST(ReadPlyAttributes, TakesPartOfAColourForALabel) {
  const AttributedMesh mesh = read_ply_attributes(ply("property uchar red\n", "0 0 0 9\n1 0 0 9\n0 1 0 9\n"), "a.ply");
  EXPECT_TRUE(mesh.colours.empty());
  EXPECT_EQ(told_attributes(mesh), "labels red");
}

TEST(ReadPlyAttributes, TakesUvsByTheirNames) {
  for (const auto& [u, v] : {std::pair("s", "t"), std::pair("u", "v"), std::pair("texture_u", "texture_v")}) {
    const std::string names = std::string("property float ") + u + "\nproperty float " + v + "\nproperty float depth\n";
    const AttributedMesh mesh = read_ply_attributes(ply(names, "0 0 0 .25 0 7\n1 0 0 1 nan 7\n0 1 0 0 1 7\n"), "a.ply");
    ASSERT_EQ(mesh.texturing.uvs.size(), 3u);
    EXPECT_EQ(mesh.texturing.uvs[0], (Uv{0.25, 0}));
    EXPECT_EQ(mesh.texturing.uvs[1], (Uv{1, 0})) << "a number that is none is 0";
    EXPECT_TRUE(mesh.texturing.has_uvs(0));
    EXPECT_EQ(told_attributes(mesh), "values depth, UVs");
  }
}

TEST(ReadPlyAttributes, TellsWhatFacesSayAndIsNotCarried) {
  const std::string content =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float depth\n"
      "element face 1\nproperty list uchar int vertex_indices\nproperty int part\nend_header\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2 5\n";
  EXPECT_THAT(read_ply_attributes(content, "a.ply").left_out, testing::ElementsAre("part of its faces; give it to the vertices"));
}

TEST_F(ReadAttributes, RefusesWhatSaysNothingOrCannot) {
  const auto message = [&](const std::string& name, const std::string& content) {
    try {
      read_attributes(write(name, content));
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message("a.ply", ply("", "0 0 0\n1 0 0\n0 1 0\n")), HasSubstr("a.ply: it says nothing but the form"));
  EXPECT_THAT(message("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), HasSubstr("are read from .ply, .obj, .gltf and .glb"));
  EXPECT_THAT(message("b.ply", ply("property uchar red\n", "0 0 0 1\n1 0 0 1\n0 1 0        \n")),
              HasSubstr("b.ply, line 13: a property is missing"));
}

}  // namespace
}  // namespace homolog
