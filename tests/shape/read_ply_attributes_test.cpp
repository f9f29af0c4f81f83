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

AttributedMesh read_alone(const std::string& content) {
  return read_ply_attributes(content, "a.ply", [](const std::string&) { return std::nullopt; });
}

TEST(ReadPlyAttributes, TakesColoursLabelsAndValuesByTheirTypes) {
  const AttributedMesh mesh =
      read_alone(ply("property float nx\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                     "property short part\nproperty double depth\nproperty list uchar int near\n",
                     "0 0 0 nan 255 51 0 -7 1.5 1 2\n1 0 0 0 0 0 255 3 nan 0\n0 1 0 0 0 0 0 3 1e300 0\n"));
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
  const AttributedMesh mesh = read_alone(ply("property float red\nproperty ushort green\nproperty uchar blue\nproperty uchar alpha\n",
                                             "0 0 0 .5 65535 0 51\n1 0 0 2 0 0 0\n0 1 0 0 0 0 255\n"));
  EXPECT_EQ(mesh.colours[0], (Rgba{0.5f, 1, 0, 0.2f}));
  EXPECT_EQ(mesh.colours[1][0], 1) << "no more than all";
  EXPECT_EQ(mesh.colours[2][3], 1);
}

TEST(ReadPlyAttributes, TakesPartOfAColourForALabel) {
  const AttributedMesh mesh = read_alone(ply("property uchar red\n", "0 0 0 9\n1 0 0 9\n0 1 0 9\n"));
  EXPECT_TRUE(mesh.colours.empty());
  EXPECT_EQ(told_attributes(mesh), "labels red");
}

TEST(ReadPlyAttributes, TakesUvsByTheirNames) {
  for (const auto& [u, v] : {std::pair("s", "t"), std::pair("u", "v"), std::pair("texture_u", "texture_v")}) {
    const std::string names = std::string("property float ") + u + "\nproperty float " + v + "\nproperty float depth\n";
    const AttributedMesh mesh = read_alone(ply(names, "0 0 0 .25 0 7\n1 0 0 1 nan 7\n0 1 0 0 1 7\n"));
    ASSERT_EQ(mesh.texturing.uvs.size(), 3u);
    EXPECT_EQ(mesh.texturing.uvs[0], (Uv{0.25, 0}));
    EXPECT_EQ(mesh.texturing.uvs[1], (Uv{1, 0})) << "a number that is none is 0";
    EXPECT_TRUE(mesh.texturing.has_uvs(0));
    EXPECT_EQ(told_attributes(mesh), "values depth, UVs");
  }
}

/// Two squares side by side, the left one of two triangles.
std::string squares(const std::string& of_vertices, const std::vector<std::string>& vertices, const std::string& of_faces,
                    const std::array<std::string, 3>& faces) {
  static const std::string places[] = {"0 0 0", "1 0 0", "2 0 0", "2 1 0", "1 1 0", "0 1 0"};
  static const std::string corners[] = {"3 0 1 4", "3 0 4 5", "4 1 2 3 4"};
  std::string text = "ply\nformat ascii 1.0\ncomment TextureFile left one.png\ncomment TextureFile right.png\nelement vertex 6\n";
  for (const char* axis : {"x", "y", "z"}) text += std::string("property float ") + axis + "\n";
  text += of_vertices + "element face 3\nproperty list uchar int vertex_indices\n" + of_faces + "end_header\n";
  for (std::size_t i = 0; i < 6; ++i) text += places[i] + (vertices.empty() ? "" : " " + vertices[i]) + "\n";
  for (std::size_t i = 0; i < 3; ++i) text += corners[i] + " " + faces[i] + "\n";
  return text;
}

TEST(ReadPlyAttributes, GivesWhatFacesSayToTheVertices) {
  const std::string colours = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  const AttributedMesh mesh = read_alone(squares("", {}, colours + "property int part\nproperty float depth\nproperty float nx\n",
                                                 {"255 0 0 7 1 0", "255 0 0 7 nan 0", "0 0 255 9 2 0"}));
  ASSERT_EQ(mesh.colours.size(), 6u);
  EXPECT_EQ(mesh.colours[0], (Rgba{1, 0, 0, 1}));
  EXPECT_EQ(mesh.colours[1], (Rgba{0.5f, 0, 0.5f, 1}));
  EXPECT_EQ(mesh.colours[2], (Rgba{0, 0, 1, 1}));
  ASSERT_EQ(mesh.fields.size(), 2u);
  EXPECT_EQ(mesh.fields[0].kind, Field::Kind::label);
  EXPECT_EQ(mesh.fields[0].values, (std::vector<double>{7, 7, 9, 9, 7, 7})) << "of as many the smaller one";
  EXPECT_EQ(mesh.fields[1].kind, Field::Kind::value);
  EXPECT_EQ(std::vector<double>(mesh.fields[1].values.begin(), mesh.fields[1].values.begin() + 5),
            (std::vector<double>{1, 1.5, 2, 2, 1.5}));
  EXPECT_TRUE(std::isnan(mesh.fields[1].values[5]));
}

TEST(ReadPlyAttributes, LeavesVerticesWhatTheySayThemselves) {
  const AttributedMesh mesh = read_alone(squares("property int part\n", {"1", "1", "1", "1", "1", "1"},
                                                 "property int part\nproperty list uchar int near\n", {"7 0", "7 0", "9 1 5"}));
  ASSERT_EQ(mesh.fields.size(), 1u);
  EXPECT_EQ(mesh.fields[0].values, std::vector<double>(6, 1));
  EXPECT_THAT(mesh.left_out, testing::Contains("near of its faces"));
  EXPECT_THAT(mesh.left_out, testing::Contains("part of its faces, as its vertices have their own"));
  EXPECT_THAT(mesh.left_out, testing::Contains("left one.png, as no UVs say where it lies"));
}

TEST_F(ReadAttributes, LaysPlyFacesOnTheirPictures) {
  write("left one.png", "L");
  const std::string uvs = "property list uchar float texcoord\nproperty int texnumber\n";
  const AttributedMesh mesh =
      read_attributes(write("a.ply", squares("", {}, uvs, {"6 0 0 .5 0 .5 1 0", "6 0 0 0 0 0 0 -1", "8 0 0 .5 0 .5 1 0 1 1"})));
  EXPECT_EQ(told_attributes(mesh), "UVs, 2 materials");
  ASSERT_EQ(mesh.mesh.triangles.size(), 4u);
  EXPECT_EQ(mesh.texturing.material_of, (std::vector<int>{0, -1, 1, 1}));
  EXPECT_FALSE(mesh.texturing.has_uvs(1));
  for (std::size_t t : {0u, 2u, 3u}) {
    for (int k = 0; k < 3; ++k) {
      const Vec3& x = mesh.mesh.vertices[mesh.mesh.triangles[t][k]];
      EXPECT_EQ(mesh.texturing.uvs[mesh.texturing.corners[t][k]], (Uv{(x.x() - (t > 0)) / 2, x.y()}));
    }
  }
  EXPECT_EQ(mesh.texturing.materials[0].name, "left one");
  EXPECT_EQ(mesh.texturing.materials[0].colour, (Rgba{1, 1, 1, 1}));
  ASSERT_EQ(mesh.texturing.images.size(), 1u);
  EXPECT_EQ(mesh.texturing.images[mesh.texturing.materials[0].image].bytes, "L");
  EXPECT_EQ(mesh.texturing.materials[1].image, -1);
  EXPECT_THAT(mesh.missing, testing::ElementsAre("right.png"));
}

TEST_F(ReadAttributes, FindsThePictureOfUvsAtPlyVertices) {
  write("skin.png", "S");
  std::string text = ply("property float s\nproperty float t\n", "0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n");
  text.replace(text.find("element"), 0, "comment TextureFile skin.png\n");
  const AttributedMesh mesh = read_attributes(write("a.ply", text));
  EXPECT_EQ(mesh.texturing.material_of, std::vector<int>{0});
  ASSERT_EQ(mesh.texturing.images.size(), 1u);
  EXPECT_EQ(mesh.texturing.images[0].bytes, "S");
  write("outside.png", "O");
  std::filesystem::create_directory(folder_ / "below");
  text.replace(text.find("skin.png"), 8, "../outside.png");
  const AttributedMesh below = read_attributes(write("below/a.ply", text));
  EXPECT_TRUE(below.texturing.images.empty()) << "it is not opened";
  ASSERT_EQ(below.left_out.size(), 1u);
  EXPECT_THAT(below.left_out[0], testing::HasSubstr("'../outside.png', which lies outside the folder"));
}

TEST(ReadPlyAttributes, KnowsPicturesOfOneNameByTheirFolders) {
  std::string text = squares("", {}, "property list uchar float texcoord\nproperty int texnumber\n",
                             {"6 0 0 .5 0 .5 1 0", "6 0 0 0 0 0 0 0", "8 0 0 .5 0 .5 1 0 1 1"});
  text.replace(text.find("left one.png"), 12, "head/skin.png");
  text.replace(text.find("right.png"), 9, "body/skin.png");
  const Texturing texturing = read_ply_attributes(text, "a.ply", [](const std::string& name) { return "PNG of " + name; }).texturing;
  EXPECT_EQ(texturing.images[texturing.materials[0].image].bytes, "PNG of head/skin.png");
  EXPECT_EQ(texturing.images[texturing.materials[1].image].bytes, "PNG of body/skin.png");
  EXPECT_NE(texturing.materials[0].name, texturing.materials[1].name);
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
