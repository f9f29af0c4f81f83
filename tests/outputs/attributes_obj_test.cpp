// SPDX-License-Identifier: MIT
#include "homolog/outputs/attributes_obj.h"

#include <gmock/gmock.h>

#include "homolog/shape/read_obj_attributes.h"

namespace homolog {
namespace {

using testing::HasSubstr;

AttributedMesh two_triangles() {
  AttributedMesh mesh;
  mesh.mesh = {{{0.1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  mesh.colours = {{1, 0, 0.2f, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}, {1, 1, 1, 1}};
  mesh.texturing = {{{0.25, 1e-7}, {1, 0}, {1, 1}},
                    {{0, 1, 2}, {Texturing::no_uv, Texturing::no_uv, Texturing::no_uv}},
                    {0, -1},
                    {{"old wood", {1, 0.5f, 0, 1}, 0}},
                    {{"wood.png", "PNG"}}};
  return mesh;
}

TEST(AttributesObj, IsReadAsItWasWritten) {
  const AttributedMesh mesh = two_triangles();
  const std::vector<OutputFile> files = attributes_obj(mesh, "there/b.obj", "a.obj");
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[1].path, "there/b.mtl");
  EXPECT_EQ(files[2].path, "there/b.wood.png") << "so that no picture of another mesh is overwritten";
  const AttributedMesh again = read_obj_attributes(files[0].contents, "b.obj", [&](const std::string& name) -> std::optional<std::string> {
    for (const OutputFile& file : files) {
      if (file.path.filename() == name) return file.contents;
    }
    return {};
  });
  EXPECT_EQ(again.mesh.vertices, mesh.mesh.vertices);
  EXPECT_EQ(again.mesh.triangles, mesh.mesh.triangles);
  EXPECT_EQ(again.colours, mesh.colours);
  EXPECT_EQ(again.texturing.uvs, mesh.texturing.uvs);
  EXPECT_EQ(again.texturing.corners, mesh.texturing.corners);
  const auto& materials = again.texturing.materials;
  EXPECT_EQ(materials[again.texturing.material_of[0]].name, "old wood");
  EXPECT_EQ(materials[again.texturing.material_of[0]].colour, mesh.texturing.materials[0].colour);
  EXPECT_EQ(again.texturing.images[materials[again.texturing.material_of[0]].image].bytes, "PNG");
  EXPECT_EQ(materials[again.texturing.material_of[1]].name, "not_carried");
  EXPECT_TRUE(again.missing.empty());
}

TEST(AttributesObj, IsOneFileWithoutMaterials) {
  AttributedMesh mesh = two_triangles();
  mesh.texturing = {};
  const std::vector<OutputFile> files = attributes_obj(mesh, "b.obj", "a.ply");
  ASSERT_EQ(files.size(), 1u);
  EXPECT_THAT(files[0].contents, HasSubstr("# carried from a.ply\nv 0.1 0 0 1 0 0.2\n"));
  EXPECT_THAT(files[0].contents, HasSubstr("\nf 1 2 3\nf 1 3 4\n"));
}

}  // namespace
}  // namespace homolog
