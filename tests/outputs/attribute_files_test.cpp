// SPDX-License-Identifier: MIT
#include "homolog/outputs/attribute_files.h"

#include <gmock/gmock.h>

#include "fixtures/capsule.h"
#include "homolog/base/errors.h"

namespace homolog {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

AttributedMesh rigged_capsule() {
  AttributedMesh mesh;
  mesh.mesh = capsule::mesh();
  mesh.rig = capsule::rig_of(mesh.mesh);
  return mesh;
}

TEST(AttributeFiles, AreOfTheFormatThatTheNameAsksFor) {
  const AttributedMesh mesh = rigged_capsule();
  const std::vector<DensePlace> places(mesh.mesh.vertices.size());
  EXPECT_EQ(attribute_files(mesh, places, "a.GLB", "b")[0].contents.substr(0, 4), "glTF");
  EXPECT_EQ(attribute_files(mesh, places, "a.gltf", "b")[1].path, "a.bin");
  EXPECT_EQ(attribute_files(mesh, places, "a.ply", "b")[0].contents.substr(0, 3), "ply");
  EXPECT_EQ(attribute_files(mesh, places, "a.obj", "b")[0].contents.substr(0, 1), "#");
  EXPECT_THROW(attribute_files(mesh, places, "a.stl", "b"), OutputError);
}

TEST(AttributeLosses, TellWhatAFormatCannotHold) {
  AttributedMesh mesh = rigged_capsule();
  EXPECT_THAT(attribute_losses(mesh, "a.glb", "b"), IsEmpty());
  EXPECT_THAT(attribute_losses(mesh, "a.obj", "b"),
              ElementsAre("weights, joints, shape keys and animations are written to a .glb or .gltf alone"));
  mesh.rig = {};
  mesh.texturing.gltf = R"({"materials": [{"name": "skin", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}]})";
  EXPECT_THAT(attribute_losses(mesh, "a.obj", "b"), IsEmpty());
  mesh.texturing.gltf = R"({"materials": [{"name": "skin", "pbrMetallicRoughness": {"metallicFactor": 0.5}}]})";
  EXPECT_THAT(attribute_losses(mesh, "a.obj", "b"),
              ElementsAre("of materials an .obj holds the base colour and its picture alone; a .glb holds more"));
  mesh.texturing = {};
  mesh.fields = {{"depth", Field::Kind::value, {}}};
  mesh.left_out = {"its animations"};
  EXPECT_THAT(attribute_losses(mesh, "a.ply", "b.glb"), ElementsAre("b.glb: not carried: its animations"));
  EXPECT_EQ(attribute_losses(mesh, "a.obj", "b").back(), ".obj files hold no values and no labels; .ply and .glb files do");
}

}  // namespace
}  // namespace homolog
