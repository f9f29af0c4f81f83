// SPDX-License-Identifier: MIT
#include "homolog/outputs/attributes_ply.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "homolog/shape/read_ply_attributes.h"

namespace homolog {
namespace {

using testing::HasSubstr;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
const Mesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
const std::vector<DensePlace> places{{0, Vec3(1, 0, 0), Vec3::Zero(), 1}, {0, Vec3(0, 1, 0), Vec3::UnitX(), 1}, {}};

/// From the file and the pictures beside it.
AttributedMesh read_again(const std::vector<OutputFile>& files) {
  return read_ply_attributes(files[0].contents, "b.ply", [&](const std::string& name) {
    const auto file = std::find_if(files.begin(), files.end(), [&](const OutputFile& file) { return file.path.filename() == name; });
    return file == files.end() ? std::nullopt : std::optional(file->contents);
  });
}

/// Two triangles on two pictures, and one without UVs.
AttributedMesh textured() {
  AttributedMesh mesh{{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}}, {}, {}};
  constexpr std::uint32_t no_uv = Texturing::no_uv;
  mesh.texturing.uvs = {{0, 0}, {0.5, 0}, {0.5, 1}, {0.25, 1}};
  mesh.texturing.corners = {{0, 1, 2}, {1, 2, 3}, {no_uv, no_uv, no_uv}};
  mesh.texturing.material_of = {1, 0, -1};
  mesh.texturing.images = {{"a.png", "A"}, {"b.png", "B"}};
  mesh.texturing.materials = {{"fur", {1, 1, 1, 1}, 0}, {"nose", {1, 1, 1, 1}, 1}};
  return mesh;
}

TEST(AttributesPly, LaysFacesOnPicturesWhereSeamsAre) {
  const AttributedMesh mesh = textured();
  EXPECT_FALSE(ply_leaves_out(mesh.texturing));
  const std::vector<OutputFile> files = attributes_ply(mesh, {{}, {}, {}, {}}, "out/b.ply", "a.ply");
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[2].path, "out/b.b.png");
  EXPECT_THAT(files[0].contents, HasSubstr("\ncomment TextureFile b.a.png\ncomment TextureFile b.b.png\n"));
  EXPECT_THAT(files[0].contents, HasSubstr("\n3 0 1 2 6 0 0 0.5 0 0.5 1 1\n3 0 2 3 6 0.5 0 0.5 1 0.25 1 0\n3 0 3 1 6 0 0 0 0 0 0 -1\n"));
  const Texturing again = read_again(files).texturing;
  EXPECT_EQ(again.material_of, mesh.texturing.material_of);
  EXPECT_EQ(again.images[again.materials[1].image].bytes, "B");
  for (std::size_t t : {0u, 1u}) {
    for (int k = 0; k < 3; ++k) EXPECT_EQ(again.uvs[again.corners[t][k]], mesh.texturing.uvs[mesh.texturing.corners[t][k]]);
  }
  EXPECT_FALSE(again.has_uvs(2));
}

TEST(AttributesPly, LaysVerticesOnOnePictureWhereNoSeamIs) {
  AttributedMesh mesh = textured();
  mesh.mesh.triangles.pop_back();
  mesh.texturing.corners = {{0, 1, 2}, {0, 2, 3}};
  mesh.texturing.materials.erase(mesh.texturing.materials.begin());
  mesh.texturing.material_of = {0, 0};
  const std::string text = attributes_ply(mesh, {{}, {}, {}, {}}, "b.ply", "a.ply")[0].contents;
  EXPECT_THAT(text, HasSubstr("comment TextureFile b.b.png\n"));
  EXPECT_THAT(text, HasSubstr("property float s\nproperty float t\nproperty uchar carried\n"));
  EXPECT_THAT(text, HasSubstr("\n0 1 0 0.25 1 0\n3 0 1 2\n3 0 2 3\n"));
  mesh.texturing.materials[0].colour[0] = 0.5f;
  EXPECT_TRUE(ply_leaves_out(mesh.texturing));
}

TEST(AttributesPly, IsReadAsItWasWritten) {
  const AttributedMesh mesh{triangle,
                            {{1, 0.2f, 0, 1}, {0, 0, 1, 0.4f}, no_colour},
                            {{"depth", Field::Kind::value, {0.1, 1e-300, none}}, {"part", Field::Kind::label, {16777217, -5, none}, -6}}};
  const std::string text = attributes_ply(mesh, places, "out/b.ply", "bear\n.ply")[0].contents;
  EXPECT_THAT(text, HasSubstr("comment carried from bear .ply; where 'carried' is 0 values are nan, 'part' -6\n"));
  EXPECT_THAT(text, HasSubstr("property uchar alpha\nproperty double depth\nproperty int part\nproperty uchar carried\n"));
  EXPECT_THAT(text, HasSubstr("\n0 1 0 128 128 128 255 nan -6 0\n"));
  const AttributedMesh again = read_again({{"b.ply", text}});
  EXPECT_EQ(again.mesh.vertices, triangle.vertices);
  EXPECT_EQ(again.colours, mesh.colours);
  ASSERT_EQ(again.fields.size(), 3u);
  EXPECT_EQ(again.fields[0].values[1], 1e-300);
  EXPECT_EQ(again.fields[1].values, (std::vector<double>{16777217, -5, -6}));
  EXPECT_EQ(again.fields[2].values, (std::vector<double>{1, 1, 0}));
}

TEST(AttributesPly, SaysOnceWhatWasCarried) {
  const AttributedMesh mesh{triangle, {}, {{"carried", Field::Kind::label, {1, 1, 1}}, {"big", Field::Kind::label, {4e9, 1, none}}}};
  const std::string text = attributes_ply(mesh, places, "b.ply", "a.ply")[0].contents;
  EXPECT_THAT(text, HasSubstr("property double z\nproperty double big\nproperty uchar carried\nelement face"));
}

}  // namespace
}  // namespace homolog
