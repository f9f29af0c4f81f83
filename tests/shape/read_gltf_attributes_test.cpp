// SPDX-License-Identifier: MIT
#include "homolog/shape/read_gltf_attributes.h"

#include <gmock/gmock.h>

#include <functional>

#include "homolog/base/errors.h"
#include "homolog/outputs/glb.h"
#include "homolog/shape/read_attributes.h"
#include "shape/files.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;

/// A square of two triangles, whose joints turn, scale and shift it below a node that does, with everything that is read. The node of the
/// mesh stands elsewhere, which moves no mesh with a skin.
struct File {
  GltfContent content;
  ordered_json json;

  File() {
    const GltfTarget none = GltfTarget::none;
    ordered_json attributes, target;
    attributes["POSITION"] = add_bounded_table(content, Floats{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, 3, none);
    attributes["TEXCOORD_0"] = add_table(content, Floats{0, 1, 1, 1, 1, 0.25f, 0, 0}, 2, none);
    attributes["COLOR_0"] = add_table(content, std::vector<std::uint8_t>{255, 0, 0, 255, 55, 0, 0, 255, 0, 0, 0, 0, 0, 0, 0, 255}, 4, none);
    content.accessors.back()["normalized"] = true;
    attributes["JOINTS_0"] = add_table(content, std::vector<std::uint8_t>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}, 4, none);
    attributes["WEIGHTS_0"] = add_table(content, Floats{1, 0, 0, 0, 1, 3, 0, 0, 1, 0, 0, 0, 0.5f, 0, 0, 0}, 4, none);
    target["POSITION"] = add_bounded_table(content, Floats{0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 3, none);
    Floats inverses(32, 0);
    for (std::size_t joint = 0; joint < 2; ++joint) {
      for (std::size_t k = 0; k < 4; ++k) inverses[16 * joint + 5 * k] = 1;
    }
    inverses[16 + 12] = -1;  // the second joint stands at x = 1 of the mesh
    const int matrices = add_table(content, inverses, 16, none),
              indices = add_table(content, std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3}, 1, none);
    const ordered_json primitive = {{"attributes", attributes}, {"indices", indices}, {"material", 0}, {"targets", {target}}};
    json = {{"scene", 0},
            {"scenes", {{{"nodes", {0, 1}}}}},
            {"nodes",
             {{{"mesh", 0}, {"skin", 0}, {"scale", {3, 3, 3}}, {"translation", {1, 2, 3}}},
              {{"name", "armature"},
               {"children", {2}},
               {"scale", {2, 2, 2}},
               {"rotation", {0, 0, 0.70710678118654757, 0.70710678118654757}},
               {"translation", {0, 0, 5}}},
              {{"name", "root"}, {"children", {3}}},
              {{"name", "between"}, {"children", {4}}},
              {{"name", "tip"}, {"translation", {1, 0, 0}}}}},
            {"meshes", {{{"primitives", {primitive}}, {"weights", {0.5}}, {"extras", {{"targetNames", {"up"}}}}}}},
            {"skins", {{{"joints", {2, 4}}, {"inverseBindMatrices", matrices}}}},
            {"materials",
             {{{"name", "paint"},
               {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
               {"normalTexture", {{"index", 0}, {"texCoord", 1}}}}}},
            {"textures", {{{"source", 0}}}},
            {"images", {{{"uri", "a%20b.png"}}}}};
  }

  ordered_json& accessor(int number) { return content.accessors[static_cast<std::size_t>(number)]; }
  ordered_json& primitive() { return json["meshes"][0]["primitives"][0]; }
  std::string glb() const { return glb_bytes(gltf_document(json, content), content); }
};

std::optional<std::string> nothing(const std::string&) { return {}; }
std::optional<std::string> a_picture(const std::string& name) {
  return name == "a b.png" ? std::optional<std::string>("PNG") : std::nullopt;
}

AttributedMesh read(const File& file, const FindOther& find_other = a_picture) {
  return read_gltf_attributes(file.glb(), "a.glb", find_other, 1000);
}

TEST(ReadGltfAttributes, ReadsAllThatIsOnTheMesh) {
  const AttributedMesh mesh = read({});
  ASSERT_EQ(mesh.mesh.vertices.size(), 4u);
  EXPECT_TRUE(mesh.mesh.vertices[1].isApprox(Vec3(0, 2, 5), 1e-6)) << "turned by a quarter about z, twice as large, shifted, by the joints";
  EXPECT_EQ(mesh.mesh.triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
  EXPECT_NEAR(mesh.colours[1][0], 0.5019, 1e-3) << "55 / 255 of the light is half as bright on a screen";
  EXPECT_EQ(mesh.colours[2][3], 0);
  EXPECT_EQ(mesh.texturing.uvs[mesh.texturing.corners[1][1]], (Uv{1, 0.75})) << "counted from below";
  EXPECT_EQ(mesh.texturing.materials[0].name, "paint");
  EXPECT_EQ(mesh.texturing.images[0].name, "a b.png");
  EXPECT_EQ(mesh.texturing.images[0].bytes, "PNG");
  EXPECT_THAT(mesh.texturing.gltf, Not(HasSubstr("normalTexture")));
  EXPECT_THAT(mesh.left_out, testing::ElementsAre("textures by a second set of UVs"));
  ASSERT_EQ(mesh.shape_keys.size(), 1u);
  EXPECT_EQ(mesh.shape_keys[0].name, "up");
  EXPECT_EQ(mesh.shape_keys[0].weight, 0.5);
  EXPECT_TRUE(mesh.shape_keys[0].displacements[0].isApprox(Vec3(0, 0, 2), 1e-6));
  EXPECT_EQ(told_attributes(mesh), "colours, UVs, 1 material, weights of 2 joints, 1 shape key");
}

TEST(ReadGltfAttributes, PlacesJointsAsTheirBindMatricesSay) {
  const AttributedMesh mesh = read({});
  ASSERT_EQ(mesh.rig.joints.size(), 2u);
  EXPECT_EQ(mesh.rig.joints[1].name, "tip");
  EXPECT_EQ(mesh.rig.joints[1].parent, 0) << "by the node between them";
  EXPECT_EQ(mesh.rig.joints[0].parent, -1);
  EXPECT_TRUE(mesh.rig.joints[1].bind.topRightCorner(3, 1).isApprox(Vec3(0, 2, 5), 1e-6)) << "where vertex 1 is";
  EXPECT_EQ(mesh.rig.influences[0][0].joint, 1);
  EXPECT_FLOAT_EQ(mesh.rig.influences[1][0].weight, 0.75f) << "the strongest first, their sum 1";
  EXPECT_FLOAT_EQ(mesh.rig.influences[3][0].weight, 1);
}

TEST(ReadGltfAttributes, ReadsASecondSetOfWeights) {
  File file;
  ordered_json& attributes = file.primitive()["attributes"];
  attributes["JOINTS_1"] = attributes["JOINTS_0"];
  attributes["WEIGHTS_1"] = add_table(file.content, Floats{1, 0, 0, 0, 0, 4, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 4, GltfTarget::none);
  const AttributedMesh mesh = read(file);
  EXPECT_FLOAT_EQ(mesh.rig.influences[1][0].weight, 0.875f) << "3 + 4 of 8";
  EXPECT_THAT(mesh.left_out, Not(testing::Contains(HasSubstr("weights"))));
}

TEST(ReadGltfAttributes, TellsOfSecondSetsAndVectorsOnce) {
  File file;
  ordered_json& attributes = file.primitive()["attributes"];
  attributes["TEXCOORD_1"] = attributes["TEXCOORD_0"];
  attributes["COLOR_1"] = attributes["COLOR_0"];
  attributes["_WIND"] = attributes["POSITION"];
  file.json["materials"].clear();
  file.primitive().erase("material");
  ordered_json& primitives = file.json["meshes"][0]["primitives"];
  primitives.push_back(ordered_json(file.primitive()));
  primitives[1]["attributes"]["TEXCOORD_0"] = attributes["TEXCOORD_0"];
  EXPECT_THAT(read(file).left_out,
              testing::ElementsAre("a second set of colours", "a second set of UVs", "the attribute _WIND, which has several numbers"));
}

/// With an animation that moves a node by these values at the times 0 and 2.
void animate(File& file, int node, const char* path, const Floats& values, int columns, const Floats& times = {0, 2}) {
  const int input = add_bounded_table(file.content, times, 1, GltfTarget::none),
            output = add_table(file.content, values, columns, GltfTarget::none);
  file.json["animations"] = {{{"name", "course"},
                              {"samplers", {{{"input", input}, {"output", output}}}},
                              {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}}}}};
}

TEST(ReadGltfAttributes, ReadsWhereJointsMove) {
  File file;
  animate(file, 3, "translation", {0, 0, 0, 0, 4, 0}, 3);  // the node between both joints
  const AttributedMesh mesh = read(file);
  ASSERT_EQ(mesh.animations.size(), 1u);
  const Animation& course = mesh.animations[0];
  EXPECT_EQ(course.name, "course");
  EXPECT_THAT(course.times, testing::ElementsAre(0, 2));
  EXPECT_TRUE(course.poses[0][1].shift.isApprox(Vec3(0, 0, 5), 1e-6)) << "where its node stands";
  EXPECT_TRUE(course.poses[1][0].shift.isApprox(Vec3(1, 0, 0), 1e-6)) << "in its parent, the root";
  EXPECT_TRUE(course.poses[1][1].shift.isApprox(Vec3(1, 4, 0), 1e-6));
  EXPECT_THAT(course.weights[0], testing::ElementsAre(0.5, 0.5)) << "as it is";
  EXPECT_EQ(told_attributes(mesh), "colours, UVs, 1 material, weights of 2 joints, 1 shape key, 1 animation");
}

TEST(ReadGltfAttributes, SeesWhatMovesAboveAllJoints) {
  File file;
  animate(file, 1, "rotation", {0, 0, 0, 1, 0, 0, 0.70710678f, 0.70710678f}, 4);
  const Animation course = read(file).animations.at(0);
  EXPECT_NEAR(course.poses[0][1].turn.angularDistance(course.poses[0][0].turn), M_PI / 2, 1e-6);
  EXPECT_NEAR(course.poses[1][1].turn.angularDistance(course.poses[1][0].turn), 0, 1e-6) << "in its parent it stands";
}

TEST(ReadGltfAttributes, ReadsHowShapeKeysMove) {
  File file;
  animate(file, 0, "weights", {0, 1}, 1);
  EXPECT_THAT(read(file).animations.at(0).weights.at(0), testing::ElementsAre(0, 1));
}

TEST(ReadGltfAttributes, TellsOfAnimationsThatMoveNothingCarried) {
  File file;
  animate(file, 0, "translation", {0, 0, 0, 1, 1, 1}, 3);  // the mesh itself, which stands where its joints say
  const AttributedMesh mesh = read(file);
  EXPECT_TRUE(mesh.animations.empty());
  EXPECT_THAT(mesh.left_out, testing::Contains("'course', an animation of neither joints nor shape keys"));
}

TEST(ReadGltfAttributes, TellsOfPicturesThatAreNotThere) {
  const AttributedMesh mesh = read({}, nothing);
  EXPECT_THAT(mesh.missing, testing::ElementsAre("a b.png"));
  EXPECT_EQ(mesh.texturing.images[0].bytes, "");
}

using ReadGltfAttributesFromFile = FileTest;

TEST_F(ReadGltfAttributesFromFile, LiesWhereReadMeshPutsIt) {
  const std::filesystem::path path = write("lies.glb", File().glb());
  const Mesh mesh = read_mesh(path);
  const AttributedMesh attributed = read_attributes(path);
  ASSERT_EQ(mesh.vertices.size(), attributed.mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    double nearest = 1;
    for (const Vec3& vertex : attributed.mesh.vertices) nearest = std::min(nearest, (vertex - mesh.vertices[i]).norm());
    EXPECT_LT(nearest, 1e-5);
  }
}

TEST(ReadGltfAttributes, ReadsPositionsThatAreOnlySparse) {
  File file;
  const int rows = add_table(file.content, std::vector<std::uint16_t>{1, 3}, 1, GltfTarget::none),
            values = add_table(file.content, Floats{1, 0, 0, 0, 3, 0}, 3, GltfTarget::none);
  file.accessor(0).erase("bufferView");
  file.accessor(0)["sparse"] = {{"count", 2},
                                {"indices", {{"bufferView", file.accessor(rows)["bufferView"]}, {"componentType", 5123}}},
                                {"values", {{"bufferView", file.accessor(values)["bufferView"]}}}};
  const std::vector<Vec3> vertices = read(file).mesh.vertices;
  EXPECT_TRUE(vertices[1].isApprox(Vec3(0, 2, 5), 1e-6)) << "given";
  EXPECT_TRUE(vertices[2].isApprox(Vec3(0, 0, 5), 1e-6)) << "not given: at the origin, which the joints shift";
  EXPECT_TRUE(vertices[3].isApprox(Vec3(-6, 0, 5), 1e-6));
  file.accessor(0)["count"] = 4'000'000'000;
  EXPECT_THROW(read(file), FileError) << "before it takes memory";
}

/// What is said of a file that was spoilt.
std::string refusal(const std::function<void(File&)>& spoil) {
  File file;
  spoil(file);
  try {
    read(file);
  } catch (const FileError& error) {
    return error.what();
  }
  return "read";
}

TEST(ReadGltfAttributes, RefusesWhatIsDamaged) {
  const char* end = "; the file is damaged, export it again";
  EXPECT_EQ(refusal([](File&) {}), "read");
  EXPECT_EQ(refusal([](File& f) { f.primitive()["attributes"]["COLOR_0"] = 99; }),
            "a.glb: number 99 of its accessors does not exist" + std::string(end));
  EXPECT_EQ(refusal([](File& f) { f.primitive()["attributes"].erase("POSITION"); }), "a.glb: a mesh has no POSITION" + std::string(end));
  EXPECT_THAT(refusal([](File& f) { f.accessor(0)["count"] = 4'000'000'000; }), HasSubstr("its POSITION reaches beyond its view"));
  EXPECT_THAT(refusal([](File& f) { f.accessor(0).erase("bufferView"); }), HasSubstr("its POSITION has no data"));
  EXPECT_THAT(refusal([](File& f) { f.accessor(0)["count"] = -4; }), HasSubstr("'count' is not a whole number from 0 on"));
  EXPECT_THAT(refusal([](File& f) { f.accessor(1)["count"] = 3; }), HasSubstr("its TEXCOORD_0 has 3 entries where 4 are needed"));
  EXPECT_THAT(refusal([](File& f) { f.accessor(1)["type"] = "VEC3"; }), HasSubstr("its TEXCOORD_0 is not of a type that it can be"));
  EXPECT_THAT(refusal([](File& f) { f.accessor(1)["componentType"] = 1; }), HasSubstr("a component type that glTF does not know"));
  EXPECT_THAT(refusal([](File& f) { f.content.views[0]["byteOffset"] = 1ull << 63; }), HasSubstr("view 0 reaches beyond its buffer"));
  EXPECT_THAT(refusal([](File& f) { f.content.views[0]["byteStride"] = 1; }), HasSubstr("its POSITION reaches beyond its view"));
  EXPECT_THAT(refusal([](File& f) { f.content.bytes[f.content.views[7]["byteOffset"].get<std::size_t>()] = 9; }),
              HasSubstr("a triangle names vertex 9 of 4"));
  EXPECT_THAT(refusal([](File& f) { f.content.bytes[f.content.views[3]["byteOffset"].get<std::size_t>()] = 9; }),
              HasSubstr("vertex 0 of a mesh follows joint 9, which its skin does not have"));
  EXPECT_THAT(refusal([](File& f) {
                f.content.bytes.replace(f.content.views[1]["byteOffset"].get<std::size_t>(), 4, std::string("\0\0\xc0\x7f", 4));
              }),
              HasSubstr("its TEXCOORD_0 holds a number that is not finite"));
  EXPECT_THAT(refusal([](File& f) {
                f.json["skins"][0]["joints"] = {2, 4, 3};
              }),
              HasSubstr("skin 0 has fewer inverse bind matrices than joints"));
  EXPECT_THAT(refusal([](File& f) { f.json["skins"][0]["joints"] = {2, 44}; }), HasSubstr("number 44 of its nodes does not exist"));
  EXPECT_THAT(refusal([](File& f) { f.json["nodes"][4]["children"] = {1}; }), HasSubstr("node 1 stands in two places"));
  EXPECT_THAT(refusal([](File& f) { f.json["nodes"][0]["scale"] = {1, "a", 2}; }), HasSubstr("'scale' is not 3 finite numbers"));
  EXPECT_THAT(refusal([](File& f) { f.primitive()["material"] = 5; }), HasSubstr("material 5 does not exist"));
  EXPECT_THAT(refusal([](File& f) { f.json["textures"][0]["source"] = 5; }), HasSubstr("image 5 does not exist"));
  EXPECT_THAT(refusal([](File& f) { f.json["images"][0]["uri"] = "data:image/png;base64,#"; }), HasSubstr("data inside it is not base64"));
  EXPECT_THAT(refusal([](File& f) { animate(f, 3, "scale", {1, 1, 1, 1, 1, 1}, 3, {2, 1}); }), HasSubstr("do not ascend from 0 on"));
  EXPECT_THAT(refusal([](File& f) { animate(f, 3, "scale", {1, 1, 1}, 3); }), HasSubstr("an animation has not one value for each time"));
  EXPECT_THAT(refusal([](File& f) { animate(f, 0, "weights", {1, 1, 1, 1}, 1); }), HasSubstr("has not one weight for each target"));
  EXPECT_THAT(refusal([](File& f) {
                animate(f, 3, "scale", {1, 1, 1, 1, 1, 1}, 3);
                f.json["animations"][0]["channels"][0]["sampler"] = 4;
              }),
              HasSubstr("sampler 4 of an animation does not exist"));
  EXPECT_EQ(refusal([](File& f) { f.json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }),
            "a.glb: its meshes are compressed (KHR_draco_mesh_compression), which is not read; export it without compression");
  EXPECT_EQ(refusal([](File& f) {
              f.accessor(0).erase("bufferView");  // not required, and yet there is nothing else
              f.primitive()["extensions"]["KHR_draco_mesh_compression"]["bufferView"] = 0;
            }),
            "a.glb: its meshes are compressed (KHR_draco_mesh_compression), which is not read; export it without compression");
  EXPECT_EQ(refusal([](File& f) { f.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"] = ordered_json::object(); }),
            "a.glb: it needs the extension 'EXT_mesh_gpu_instancing', which is not read; export it without");
}

TEST(ReadGltfAttributes, RefusesTooMuch) {
  EXPECT_THROW(read_gltf_attributes(File().glb(), "a.glb", a_picture, 1), FileError);
  std::string deep(100000, '[');
  EXPECT_THROW(read_gltf_attributes(deep, "a.gltf", nothing, 1000), FileError);
  EXPECT_THROW(read_gltf_attributes("{\"buffers\": [{\"uri\": \"away.bin\"}]}", "a.gltf", nothing, 1000), FileError);
  const std::string glb = File().glb();
  EXPECT_THROW(read_gltf_attributes(glb.substr(0, glb.size() - 700), "a.glb", nothing, 1000), FileError);
}

}  // namespace
}  // namespace homolog
