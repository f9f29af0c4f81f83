// SPDX-License-Identifier: MIT
#include "homolog/shape/read_obj_attributes.h"

#include <gmock/gmock.h>

#include "homolog/shape/read_attributes.h"
#include "homolog/shape/read_obj.h"
#include "shape/files.h"

namespace homolog {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using ReadObjAttributes = FileTest;

const std::string obj =
    "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.2 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt .5\nusemtl red wood\n"
    "f 1/1/1 2/2 5/-1 3/3\nusemtl plain\nf 1 3 4\n";
const std::string mtl =
    "Kd 1 1 1\nnewmtl red wood # a comment\nKd 1 .5 0\nmap_Kd -s 1 1 1 wood.png\nnewmtl other\nd 0.5\nmap_Kd my\\\\pictures of it.jpg\n";

AttributedMesh read_painted(const std::string& content) {
  return read_obj_attributes(content, "a.obj", [](const std::string& name) -> std::optional<std::string> {
    if (name == "two.mtl") return mtl;
    if (name == "wood.png") return "PNG";
    return {};
  });
}

TEST_F(ReadObjAttributes, TakesUvsAndMaterialsOfTheTrianglesThatPolygonsBecome) {
  const AttributedMesh mesh = read_painted(obj);
  EXPECT_EQ(mesh.mesh.triangles, read_obj(obj, "a.obj").triangles);
  const Texturing& texturing = mesh.texturing;
  ASSERT_EQ(texturing.corners.size(), 3u);
  for (std::size_t t = 0; t < 2; ++t) {
    for (int k = 0; k < 3; ++k) {
      const Vec3& vertex = mesh.mesh.vertices[mesh.mesh.triangles[t][k]];
      const Uv& uv = texturing.uvs[texturing.corners[t][k]];
      EXPECT_EQ(uv, (vertex.x() == 0.5 ? Uv{0.5, 0} : Uv{vertex.x(), vertex.y()}));
    }
  }
  EXPECT_FALSE(texturing.has_uvs(2));
  EXPECT_THAT(texturing.material_of, ElementsAre(0, 0, 2));
  ASSERT_EQ(texturing.materials.size(), 3u);
  EXPECT_EQ(texturing.materials[0].name, "red wood");
  EXPECT_EQ(texturing.materials[0].colour, (Rgba{1, 0.5f, 0, 1}));
  EXPECT_EQ(texturing.images[texturing.materials[0].image].bytes, "PNG");
  EXPECT_EQ(texturing.materials[1].colour[3], 0.5f);
  EXPECT_EQ(texturing.materials[1].image, -1);
  EXPECT_EQ(texturing.materials[1].colour[0], 1) << "a picture is multiplied by nothing";
  EXPECT_THAT(mesh.missing, ElementsAre("my//pictures of it.jpg"));
  EXPECT_EQ(told_attributes(mesh), "UVs, 3 materials");
}

TEST_F(ReadObjAttributes, FindsPicturesBehindOptionsAndTellsWhatElseThereIsOnce) {
  std::vector<std::string> asked;
  const std::string library =
      "newmtl a\nmap_Kd -s 1 1 1 -blendu on -o 0.5 red skin.png\nmap_Bump -bm 0.2 bump.png\nnewmtl b\nmap_Kd none.png\n"
      "newmtl c\nmap_Kd none.png\nmap_Bump bump.png\nnorm n.png\n";
  const AttributedMesh mesh = read_obj_attributes("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n", "a.obj",
                                                  [&](const std::string& name) -> std::optional<std::string> {
                                                    asked.push_back(name);
                                                    if (name == "m.mtl") return library;
                                                    if (name == "red skin.png") return "PNG";
                                                    return {};
                                                  });
  EXPECT_THAT(asked, ElementsAre("m.mtl", "red skin.png", "none.png"));
  EXPECT_THAT(mesh.missing, ElementsAre("none.png"));
  EXPECT_THAT(mesh.left_out, ElementsAre("map_Bump, norm of m.mtl", "-o of map_Kd in m.mtl")) << "but -s 1 1 1 says nothing";
}

TEST_F(ReadObjAttributes, KnowsPicturesOfOneNameByTheirFolders) {
  const std::string library = "newmtl a\nmap_Kd head/skin.png\nnewmtl b\nmap_Kd body/skin.png\nnewmtl c\nmap_Kd head/./skin.png\n";
  const AttributedMesh mesh = read_obj_attributes("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n", "a.obj",
                                                  [&](const std::string& name) { return name == "m.mtl" ? library : "PNG of " + name; });
  const Texturing& texturing = mesh.texturing;
  EXPECT_EQ(texturing.images[texturing.materials[0].image].bytes, "PNG of head/skin.png");
  EXPECT_EQ(texturing.images[texturing.materials[1].image].bytes, "PNG of body/skin.png");
  EXPECT_EQ(texturing.materials[2].image, texturing.materials[0].image);
  EXPECT_NE(texturing.images[0].name, texturing.images[1].name) << "as they are written into one folder";
}

TEST_F(ReadObjAttributes, TakesColoursIfAllVerticesHaveThem) {
  EXPECT_EQ(read_painted("v 0 0 0 1 0 0.5\nv 1 0 0 0 0 0\nv 0 1 0 1 1 1\nf 1 2 3\n").colours[0], (Rgba{1, 0, 0.5f, 1}));
  EXPECT_EQ(read_painted("v 0 0 0 255 0 51\nv 1 0 0 0 0 0\nv 0 1 0 1 1 1\nf 1 2 3\n").colours[0], (Rgba{1, 0, 0.2f, 1}));
  EXPECT_EQ(read_painted("v 0 0 0 1.01 0 0.5\nv 1 0 0 0 0 0\nv 0 1 0 1 1 1\nf 1 2 3\n").colours[0], (Rgba{1, 0, 0.5f, 1}));
  EXPECT_TRUE(read_painted("v 0 0 0 1 0 0.5\nv 1 0 0\nv 0 1 0 1\nf 1 2 3\n").colours.empty());
}

TEST_F(ReadObjAttributes, LooksForPicturesInItsFolderAlone) {
  write("two.mtl", mtl);
  write("wood.png", "PNG");
  const AttributedMesh mesh = read_attributes(write("a.obj", obj));
  EXPECT_EQ(mesh.texturing.images.size(), 1u);
  const auto message = [&](const std::string& content) {
    try {
      read_attributes(write("b.obj", content));
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message("mtllib ../../../../../../../../etc/passwd\n" + obj), HasSubstr("outside its folder"));
  EXPECT_THAT(message("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/2 3/1\n"),
              HasSubstr("b.obj, line 5: texture coordinate 2 does not exist"));
  EXPECT_THAT(message("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), HasSubstr("b.obj: it says nothing but the form"));
}

TEST_F(ReadObjAttributes, TakesItsOwnNameOffPicturesThatWereWrittenWithIt) {
  write("two.mtl", "newmtl red wood\nmap_Kd a.wood.png\nnewmtl plain\nmap_Kd a.png\n");
  write("a.wood.png", "PNG");
  write("a.png", "PNG");
  const std::vector<Image> images = read_attributes(write("a.obj", obj)).texturing.images;
  ASSERT_EQ(images.size(), 2u);
  EXPECT_EQ(images[0].name, "wood.png");
  EXPECT_EQ(images[1].name, "a.png");
}

/// Blender names pictures so that are kept elsewhere.
TEST_F(ReadObjAttributes, LeavesPicturesOutsideItsFolderAlone) {
  std::filesystem::create_directory(folder_ / "export");
  write("wood.png", "PNG");
  for (const std::string& named : {std::string("../wood.png"), (folder_ / "wood.png").string()}) {
    write("export/two.mtl", "newmtl red\nKd 1 0 0\nnewmtl green\nmap_Kd " + named + "\n");
    const AttributedMesh mesh = read_attributes(write("export/a.obj", obj));
    EXPECT_FALSE(mesh.texturing.uvs.empty()) << "UVs are carried all the same";
    EXPECT_TRUE(mesh.texturing.images.empty());
    EXPECT_THAT(mesh.missing, testing::IsEmpty());
    ASSERT_EQ(mesh.left_out.size(), 1u);
    EXPECT_THAT(mesh.left_out[0], HasSubstr("'" + named.substr(0, 100) + "', which lies outside the folder of the file"));
  }
}

}  // namespace
}  // namespace homolog
