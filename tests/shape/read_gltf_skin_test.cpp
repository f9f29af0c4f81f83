// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "fixtures/skinned_capsule.h"
#include "homolog/base/errors.h"
#include "homolog/shape/read_gltf.h"
#include "homolog/shape/read_gltf_attributes.h"

namespace homolog {
namespace {

using capsule::SkinnedFile;

std::optional<std::string> nothing(const std::string&) { return {}; }

AttributedMesh read(const SkinnedFile& file) { return read_gltf_attributes(file.glb(), "a.glb", nothing, 1'000'000); }

double most_apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  EXPECT_EQ(a.size(), b.size());
  double most = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

/// Both readers put the vertices there.
void expect_shown(const SkinnedFile& file, const std::vector<Vec3>& vertices) {
  EXPECT_LT(most_apart(read(file).mesh.vertices, vertices), 1e-5);
  EXPECT_EQ(read_gltf(file.glb(), "a.glb", nothing, 1'000'000).vertices, read(file).mesh.vertices);
}

TEST(ReadGltfSkin, StandsWhereItsJointsDoAndNotItsNode) {
  SkinnedFile file;
  expect_shown(file, file.shown.vertices);
  const AttributedMesh mesh = read(file);
  for (std::size_t i = 0; i < 2; ++i) {
    const Mat4 &is = mesh.rig.joints[i].bind, &wanted = file.rig.joints[i].bind;
    EXPECT_LT((is.topRightCorner<3, 1>() - wanted.topRightCorner<3, 1>()).norm(), 1e-5);
    EXPECT_LT((is.topLeftCorner<3, 3>() * 100 - wanted.topLeftCorner<3, 3>()).norm(), 1e-5) << "as small as the armature makes it";
  }
  file.json["nodes"][1]["scale"] = {1, 1, 1};
  file.json["nodes"][0]["children"] = {2};
  file.json["scenes"][0]["nodes"] = {0, 1};
  expect_shown(file, file.shown.vertices);
}

TEST(ReadGltfSkin, StandsInThePoseOfItsNodes) {
  const SkinnedFile file(0.8);
  expect_shown(file, capsule::bent(file.shown, file.rig, 0.8));
}

TEST(ReadGltfSkin, AppliesShapeKeysByTheWeightsOfTheFile) {
  SkinnedFile file;
  const ShapeKey nose = capsule::nose_of(file.shown);
  std::vector<Vec3> moved = file.shown.vertices;
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += 0.5 * nose.displacements[i];
  file.json["meshes"][0]["weights"] = {0.5};
  expect_shown(file, moved);
  EXPECT_LT(most_apart(read(file).shape_keys.at(0).displacements, nose.displacements), 1e-5);
  EXPECT_EQ(read(file).shape_keys[0].weight, 0.5);
  file.json["nodes"][1]["weights"] = {0};
  expect_shown(file, file.shown.vertices);
  EXPECT_EQ(read(file).shape_keys[0].weight, 0) << "the node's own weights come first";
}

TEST(ReadGltfSkin, LetsVerticesWithoutWeightsGoWithTheFirstJoint) {
  SkinnedFile file(0.8);
  const auto weights = file.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"].get<std::size_t>();
  const auto offset = file.content.views[file.content.accessors[weights]["bufferView"].get<std::size_t>()]["byteOffset"].get<std::size_t>();
  file.content.bytes.replace(offset, 16 * file.shown.vertices.size(), 16 * file.shown.vertices.size(), '\0');
  expect_shown(file, file.shown.vertices);
  EXPECT_EQ(read(file).rig.influences[7][0].weight, 0);
}

TEST(ReadGltfSkin, BindsOneSkeletonToSeveralMeshesInSeveralWays) {
  SkinnedFile file;
  file.json["nodes"].push_back({{"mesh", 0}, {"skin", 1}});
  file.json["scenes"][0]["nodes"].push_back(4);
  file.json["skins"].push_back({{"joints", {2, 3}}});  // without inverse bind matrices: as large as the armature makes it
  const AttributedMesh mesh = read(file);
  ASSERT_EQ(mesh.mesh.vertices.size(), 2 * file.shown.vertices.size());
  EXPECT_EQ(mesh.rig.joints.size(), 2u);
  EXPECT_THAT(mesh.left_out, testing::IsEmpty());
  const Vec3 table = (file.armature.inverse() * file.shown.vertices[0].homogeneous()).head<3>();
  const Influences& follows = mesh.rig.influences[0];
  Vec3 wanted = Vec3::Zero();
  for (const auto& [joint, weight] : follows) wanted += weight * (mesh.rig.joints[joint].bind * table.homogeneous()).head<3>();
  EXPECT_LT((mesh.mesh.vertices[0] - wanted).norm(), 1e-5) << "the node at the top comes first";
  EXPECT_LT((mesh.mesh.vertices[file.shown.vertices.size()] - file.shown.vertices[0]).norm(), 1e-5);
}

TEST(ReadGltfSkin, ReadsJointsThatAreDrawnToNothing) {
  SkinnedFile file;
  file.json["nodes"][3]["scale"] = {0, 0, 0};
  const AttributedMesh mesh = read(file);
  EXPECT_TRUE(mesh.rig.joints[1].bind.inverse().allFinite());
  for (const Vec3& vertex : mesh.mesh.vertices) EXPECT_LT(vertex.x(), 0.4) << "the half that follows it is drawn to the joint";
}

}  // namespace
}  // namespace homolog
