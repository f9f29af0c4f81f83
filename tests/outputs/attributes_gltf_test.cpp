// SPDX-License-Identifier: MIT
#include "homolog/outputs/attributes_gltf.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "fixtures/capsule.h"
#include "homolog/outputs/gltf_materials.h"
#include "homolog/shape/gltf_file.h"
#include "homolog/shape/read_gltf_attributes.h"

namespace homolog {
namespace {

constexpr const char* png = "\x89PNG and more";

/// A capsule with everything: its UVs are two islands that meet where y = 0.
AttributedMesh capsule_with_everything() {
  AttributedMesh mesh;
  mesh.mesh = capsule::mesh();
  mesh.rig = capsule::rig_of(mesh.mesh);
  mesh.shape_keys = {capsule::nose_of(mesh.mesh)};
  for (const Vec3& x : mesh.mesh.vertices) mesh.colours.push_back({0.2f, x.x() > 0 ? 1.0f : 0.0f, 0.5f, 0.75f});
  Texturing& texturing = mesh.texturing;
  for (const auto& triangle : mesh.mesh.triangles) {
    const double y = mesh.mesh.vertices[triangle[0]].y() + mesh.mesh.vertices[triangle[1]].y() + mesh.mesh.vertices[triangle[2]].y();
    const auto shift = static_cast<std::uint32_t>(y > 0 ? mesh.mesh.vertices.size() : 0);
    texturing.corners.push_back({triangle[0] + shift, triangle[1] + shift, triangle[2] + shift});
    texturing.material_of.push_back(y > 0 ? 1 : 0);
  }
  for (const double u : {0.25, 0.75}) {
    for (const Vec3& x : mesh.mesh.vertices) texturing.uvs.push_back({u + x.x() / 10, 0.5 + x.z()});
  }
  texturing.corners[3] = {Texturing::no_uv, Texturing::no_uv, Texturing::no_uv};
  texturing.material_of[3] = -1;
  texturing.materials = {{"under", {0.5f, 0.25f, 1, 0.5f}, -1}, {"over", {1, 1, 1, 1}, 0}};
  texturing.images = {{"skin of it.png", png}};
  return mesh;
}

AttributedMesh read_again(const std::vector<OutputFile>& files) {
  return read_gltf_attributes(
      files[0].contents, files[0].path.string(),
      [&](const std::string& name) -> std::optional<std::string> {
        for (const OutputFile& file : files) {
          if (file.path.filename() == name) return file.contents;
        }
        return {};
      },
      1'000'000);
}

/// Every triangle with its material and UVs, by where it lies.
std::map<std::vector<float>, std::vector<double>> told_triangles(const AttributedMesh& mesh) {
  std::map<std::vector<float>, std::vector<double>> told;
  for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
    std::vector<float> place;
    std::vector<double> uvs{static_cast<double>(mesh.texturing.material_of[t])};
    for (int k = 0; k < 3; ++k) {
      for (const double x : mesh.mesh.vertices[mesh.mesh.triangles[t][k]]) place.push_back(static_cast<float>(x));
      if (mesh.texturing.material_of[t] < 0) continue;
      for (const double u : mesh.texturing.uvs[mesh.texturing.corners[t][k]]) uvs.push_back(u);
    }
    told[place] = uvs;
  }
  return told;
}

/// The mesh on the very vertices of another one, none of which is further away than shape keys in single precision leave it.
AttributedMesh laid_on(AttributedMesh mesh, const Mesh& other) {
  for (Vec3& vertex : mesh.mesh.vertices) {
    const auto nearest = std::min_element(other.vertices.begin(), other.vertices.end(), [&](const Vec3& a, const Vec3& b) {
      return (a - vertex).squaredNorm() < (b - vertex).squaredNorm();
    });
    EXPECT_LT((*nearest - vertex).norm(), 1e-6);
    vertex = *nearest;
  }
  return mesh;
}

TEST(AttributesGltf, IsReadAsItWasWritten) {
  const AttributedMesh mesh = capsule_with_everything();
  for (const char* name : {"there/b.glb", "there/b c.gltf"}) {
    const std::vector<OutputFile> files = attributes_gltf(mesh, name, "a.obj");
    ASSERT_EQ(files.size(), files[0].path.extension() == ".glb" ? 1u : 2u);
    const AttributedMesh again = read_again(files);
    const std::size_t count = mesh.mesh.vertices.size();
    ASSERT_GT(again.mesh.vertices.size(), count) << "a primitive for every material, vertices split at the seam";
    EXPECT_EQ(again.texturing.materials.size(), 2u);
    const auto told = told_triangles(laid_on(again, mesh.mesh)), wanted = told_triangles(mesh);
    ASSERT_EQ(told.size(), wanted.size());
    for (const auto& [place, uvs] : wanted) {
      ASSERT_TRUE(told.count(place));
      ASSERT_EQ(told.at(place).size(), uvs.size());
      for (std::size_t i = 0; i < uvs.size(); ++i) EXPECT_NEAR(told.at(place)[i], uvs[i], 1e-6);
    }
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_TRUE(again.mesh.vertices[i].isApprox(mesh.mesh.vertices[i], 1e-6)) << "vertices keep their order";
      for (int k = 0; k < 4; ++k) EXPECT_NEAR(again.colours[i][k], mesh.colours[i][k], 1e-6);
      for (int k = 0; k < 2; ++k) EXPECT_NEAR(again.rig.influences[i][k].weight, mesh.rig.influences[i][k].weight, 1e-6);
      EXPECT_EQ(again.rig.influences[i][0].joint, mesh.rig.influences[i][0].joint);
      EXPECT_TRUE(again.shape_keys[0].displacements[i].isApprox(mesh.shape_keys[0].displacements[i], 1e-6));
    }
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_TRUE(again.rig.joints[i].bind.isApprox(mesh.rig.joints[i].bind, 1e-6));
      EXPECT_EQ(again.rig.joints[i].parent, mesh.rig.joints[i].parent);
      EXPECT_EQ(again.rig.joints[i].name, mesh.rig.joints[i].name);
    }
    EXPECT_EQ(again.shape_keys[0].name, "nose");
    EXPECT_EQ(again.shape_keys[0].weight, 0.25);
    EXPECT_EQ(again.texturing.materials[1].image, 0);
    EXPECT_EQ(again.texturing.images[0].bytes, png);
    EXPECT_NEAR(again.texturing.materials[0].colour[1], 0.25, 1e-6);
    EXPECT_THAT(again.left_out, testing::IsEmpty());
  }
}

TEST(AttributesGltf, KeepsValuesAndWhatHasNone) {
  AttributedMesh mesh = capsule_with_everything();
  std::vector<double> depth(mesh.mesh.vertices.size(), 0.5);
  depth[3] = std::nan("");
  mesh.fields = {{"depth", Field::Kind::value, depth}};
  const AttributedMesh again = read_again(attributes_gltf(mesh, "there/b.glb", "a.ply"));
  ASSERT_EQ(again.fields.size(), 2u);
  for (const Field& field : again.fields) {
    EXPECT_EQ(field.kind, Field::Kind::value);
    ASSERT_EQ(field.values.size(), again.mesh.vertices.size());
    EXPECT_EQ(field.values[2], field.name == "depth" ? 0.5 : 1);
    EXPECT_EQ(field.values[3], 0) << "no number, not carried";
  }
}

TEST(AttributesGltf, WritesASecondSetOfWeightsWhereItIsNeeded) {
  AttributedMesh mesh = capsule_with_everything();
  mesh.rig.joints.resize(6, mesh.rig.joints[1]);
  mesh.rig.influences[3] = strongest_influences({{0, 6}, {1, 5}, {2, 4}, {3, 3}, {4, 2}, {5, 1}}, 8);
  const AttributedMesh again = read_again(attributes_gltf(mesh, "b.glb", "a.glb"));
  for (const std::size_t i : {2, 3}) {
    for (std::size_t k = 0; k < 8; ++k) {
      EXPECT_NEAR(again.rig.influences[i][k].weight, mesh.rig.influences[i][k].weight, 1e-6);
      if (mesh.rig.influences[i][k].weight > 0) EXPECT_EQ(again.rig.influences[i][k].joint, mesh.rig.influences[i][k].joint);
    }
  }
}

TEST(AttributesGltf, WritesHowJointsAndShapeKeysMove) {
  AttributedMesh mesh = capsule_with_everything();
  const std::vector<Pose> bound = capsule::bend_of(mesh.rig, 0), bent = capsule::bend_of(mesh.rig, 1);
  mesh.animations = {{"bend", {0, 0.5, 2}, {{bound[0], bound[0], bound[0]}, {bound[1], bent[1], bound[1]}}, {{0, 1, 0.5}}},
                     {"rest", {0, 1}, {{bound[0], bound[0]}, {bound[1], bound[1]}}, {{0.25, 0.25}}}};
  mesh.animations[0].poses[0][2].shift += Vec3(0, 1, 0);
  const AttributedMesh again = read_again(attributes_gltf(mesh, "b.glb", "a.glb"));
  ASSERT_EQ(again.animations.size(), 1u) << "one does nothing";
  EXPECT_EQ(again.animations[0].name, "bend");
  EXPECT_EQ(again.animations[0].times, mesh.animations[0].times);
  EXPECT_EQ(again.animations[0].weights, mesh.animations[0].weights);
  for (std::size_t joint = 0; joint < 2; ++joint) {
    for (std::size_t time = 0; time < 3; ++time) {
      EXPECT_TRUE(matrix_of(again.animations[0].poses[joint][time]).isApprox(matrix_of(mesh.animations[0].poses[joint][time]), 1e-6));
    }
  }
}

TEST(AttributesGltf, KeepsWhatAGltfSaysOfItsMaterials) {
  AttributedMesh mesh = capsule_with_everything();
  mesh.texturing.gltf = R"({"materials": [{"name": "gold", "pbrMetallicRoughness": {"metallicFactor": 0.9}}, {"extensions": )"
                        R"({"KHR_materials_sheen": {"sheenRoughnessFactor": 0.3}}}], "textures": [{"source": 0}], "samplers": [], )"
                        R"("extensionsRequired": ["KHR_materials_sheen"]})";
  const AttributedMesh again = read_again(attributes_gltf(mesh, "b.glb", "a.glb"));
  EXPECT_EQ(nlohmann::json::parse(again.texturing.gltf), nlohmann::json::parse(mesh.texturing.gltf));
  const GltfFile file =
      read_gltf_file(attributes_gltf(mesh, "b.glb", "a.glb")[0].contents, "b.glb", [](const std::string&) { return std::nullopt; });
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) EXPECT_EQ(file.document[list], nlohmann::json({"KHR_materials_sheen"}));
  EXPECT_FALSE(file.document.contains("samplers")) << "glTF has no empty lists";
}

TEST(AttributesGltf, TurnsASurfaceThatShowsItsInside) {
  AttributedMesh mesh;
  mesh.mesh = meshes::moved(meshes::reversed(meshes::sphere(2)), Mat3::Identity(), {1e5, 0, 0});
  mesh.colours.assign(mesh.mesh.vertices.size(), {1, 0, 0, 1});
  const AttributedMesh again = read_again(attributes_gltf(mesh, "b.glb", "a.ply"));
  EXPECT_GT(meshes::volume(meshes::moved(again.mesh, Mat3::Identity(), {-1e5, 0, 0})), 0.99 * meshes::volume(meshes::sphere(2)));
  EXPECT_LT((again.mesh.vertices[7] - mesh.mesh.vertices[7]).norm(), 1e-6) << "small far from the origin, and yet exact";
}

TEST(AttributesGltf, LeavesOutPicturesThatItCannotHold) {
  AttributedMesh mesh = capsule_with_everything();
  mesh.texturing.images[0].bytes = "BM, a bitmap";
  EXPECT_THAT(pictures_left_out(mesh.texturing), testing::ElementsAre("skin of it.png"));
  EXPECT_TRUE(read_again(attributes_gltf(mesh, "b.glb", "a.obj")).texturing.images.empty());
}

TEST(AttributesGltf, KeepsNamesOfPicturesAndNamesTheMesh) {
  const AttributedMesh mesh = capsule_with_everything();
  const std::vector<OutputFile> files = attributes_gltf(mesh, "there/b.glb", "a.obj", "bare");
  EXPECT_THAT(files[0].contents, testing::HasSubstr("{\"name\":\"bare\",\"mesh\":0"));
  EXPECT_THAT(files[0].contents, testing::HasSubstr("\"meshes\":[{\"name\":\"bare\""));
  EXPECT_EQ(read_again(files).texturing.images.at(0).name, "skin of it.png") << "with one ending";
  EXPECT_THAT(attributes_gltf(mesh, "b.glb", "a.obj", "b\xe4r")[0].contents, testing::HasSubstr("b\xef\xbf\xbdr")) << "not UTF-8";
}

TEST(AttributesGltf, WritesColourAndOpacityBesideAPicture) {
  AttributedMesh mesh = capsule_with_everything();
  mesh.texturing.materials[1].colour = {0.5f, 0.25f, 1, 0.5f};
  const std::vector<OutputFile> files = attributes_gltf(mesh, "b.glb", "a.obj");
  const Material over = read_again(files).texturing.materials.at(1);
  EXPECT_EQ(over.image, 0);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(over.colour[k], mesh.texturing.materials[1].colour[k], 1e-6);
  EXPECT_THAT(files[0].contents, testing::HasSubstr("\"alphaMode\":\"BLEND\""));
}

TEST(PictureType, IsKnownByTheFirstBytes) {
  EXPECT_EQ(picture_type(png), "image/png");
  EXPECT_EQ(picture_type("\xff\xd8\xff\xe0"), "image/jpeg");
  EXPECT_EQ(picture_type("RIFF"), "");
  EXPECT_EQ(picture_type(""), "");
}

TEST(UriOfName, IsReadBackAsTheName) {
  EXPECT_EQ(uri_of_name("a b%.png"), "a%20b%25.png");
  EXPECT_EQ(name_of_uri(uri_of_name("\xc3\xa4 #?/.png")), "\xc3\xa4 #?/.png");
}

}  // namespace
}  // namespace homolog
