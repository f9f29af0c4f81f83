// SPDX-License-Identifier: MIT
#include "homolog/shape/read_mesh.h"

#include <gmock/gmock.h>

#include "shape/files.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

using ReadMesh = FileTest;

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A box in a glTF file, once as it is and once moved and doubled by its node.
std::string gltf_text() {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
    "nodes":[{"mesh":0},{"translation":[10,0,0],"children":[2]},{"scale":[2,2,2],"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},
                 {"bufferView":1,"componentType":5125,"count":36,"type":"SCALAR"}],
    "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":144}],
    "buffers":[{"uri":"box.bin","byteLength":240}]})";
}

TEST_F(ReadMesh, AppliesTheTransformsOfGltfNodes) {
  const Mesh box = meshes::box({0, 0, 0}, {1, 1, 1});
  std::string bytes;
  for (const Vec3& v : box.vertices) {
    for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(v[axis]));
  }
  for (const auto& triangle : box.triangles) {
    for (const std::uint32_t corner : triangle) append(bytes, corner);
  }
  write("box.bin", bytes);
  const Mesh mesh = read("a.gltf", gltf_text());
  EXPECT_EQ(mesh.triangles.size(), 24u);
  EXPECT_NEAR(meshes::volume(mesh), 1 + 8, 1e-5);
  EXPECT_EQ(bounding_box(mesh).max, Vec3(12, 2, 2));
  std::string hidden = gltf_text();  // and with it what hangs on it
  hidden.insert(hidden.find(R"("children":[2])"), R"("extensions":{"KHR_node_visibility":{"visible":false}},)");
  EXPECT_EQ(read("b.gltf", hidden).triangles.size(), 12u);
  EXPECT_EQ(read("b.gltf", hidden.replace(hidden.find("false"), 5, "true")).triangles.size(), 24u);
  write("box.bin", bytes.substr(0, 100));
  expect_error("a.gltf", gltf_text(), "a buffer is longer than its data");
}

TEST_F(ReadMesh, RefusesGltfThatNeedsWhatIsNotRead) {
  const auto requiring = [](const std::string& name) { return R"({"asset":{"version":"2.0"},"extensionsRequired":[")" + name + R"("]})"; };
  for (const char* harmless : {"KHR_mesh_quantization", "KHR_materials_unlit", "KHR_texture_basisu", "EXT_texture_webp"}) {
    expect_error("a.gltf", requiring(harmless), "no triangles");
  }
  expect_error("a.gltf", requiring("KHR_draco_mesh_compression"), "its meshes are compressed (KHR_draco_mesh_compression)");
  expect_error("a.gltf",
               R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"extensions":{"EXT_meshopt_compression":{"fallback":true}}}]})",
               "its meshes are compressed (EXT_meshopt_compression)");
  for (const char* name : {"EXT_mesh_gpu_instancing", "ACME_shape", "CESIUM_RTC"}) {
    expect_error("a.gltf", requiring(name), std::string("it needs the extension '") + name + "', which is not read");
  }
}

std::string collada(const std::string& asset) {
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>)" + asset +
         R"(</asset><library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 2 3</float_array>
         <technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
         <param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/>
         </vertices><triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>
         </library_geometries><library_visual_scenes><visual_scene id="s"><node id="n"><translate>5 0 0</translate>
         <instance_geometry url="#g"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene>
         </COLLADA>)";
}

TEST_F(ReadMesh, KeepsTheNumbersOfColladaWhateverItsUnit) {
  for (const char* asset : {"", R"(<unit meter="0.01" name="centimeter"/><up_axis>Y_UP</up_axis>)",
                            R"(<unit meter="0.0254" name="inch"/><up_axis>Z_UP</up_axis>)"}) {
    EXPECT_EQ(bounding_box(read("a.dae", collada(asset))).max, Vec3(6, 2, 3)) << asset;
  }
  EXPECT_EQ(read("a.xml", collada("")).triangles.size(), 1u) << "known by its content";
}

/// The same triangle bound to a joint.
std::string skinned_collada() {
  const auto source = [](const std::string& id, const std::string& array, const std::string& parameter, int stride) {
    return "<source id=\"" + id + "\">" + array + "<technique_common><accessor source=\"#" + id + "a\" count=\"1\" stride=\"" +
           std::to_string(stride) + "\"><param " + parameter + "/></accessor></technique_common></source>";
  };
  std::string text = collada("");
  const std::string scenes = "<library_visual_scenes>", shown = R"(<instance_geometry url="#g"/>)", node = R"(<node id="n">)";
  text.replace(text.find(shown), shown.size(), R"(<instance_controller url="#c"><skeleton>#b</skeleton></instance_controller>)");
  text.insert(text.find(node), R"(<node id="b" sid="b" type="JOINT"><translate>0 7 0</translate></node>)");
  text.insert(text.find(scenes),
              R"(<library_controllers><controller id="c"><skin source="#g"><bind_shape_matrix>1 0 0 10 0 1 0 0 0 0 1 0 0 0 0 1)"
              "</bind_shape_matrix>" +
                  source("j", R"(<Name_array id="ja" count="1">b</Name_array>)", R"(name="JOINT" type="name")", 1) +
                  source("i", R"(<float_array id="ia" count="16">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</float_array>)",
                         R"(name="TRANSFORM" type="float4x4")", 16) +
                  source("w", R"(<float_array id="wa" count="1">1</float_array>)", R"(name="WEIGHT" type="float")", 1) +
                  R"(<joints><input semantic="JOINT" source="#j"/><input semantic="INV_BIND_MATRIX" source="#i"/></joints>)"
                  R"(<vertex_weights count="3"><input semantic="JOINT" source="#j" offset="0"/><input semantic="WEIGHT" source="#w" )"
                  R"(offset="1"/><vcount>1 1 1</vcount><v>0 0 0 0 0 0</v></vertex_weights></skin></controller></library_controllers>)");
  return text;
}

TEST_F(ReadMesh, PutsSkinsWhereTheirJointsStand) {
  EXPECT_EQ(bounding_box(read("a.dae", skinned_collada())).max, Vec3(11, 9, 3)) << "not where their node does";
}

std::string ac3d(const std::string& of_object = "") {
  return "\nMATERIAL \"\" rgb 1 1 1 amb 1 1 1 emis 0 0 0 spec 0 0 0 shi 0 trans 0\nOBJECT world\nkids 1\nOBJECT poly\n" + of_object +
         "numvert 3\n0 0 0\n1 0 0\n0 2 3\nnumsurf 1\nSURF 0x20\nmat 0\nrefs 3\n0 0 0\n1 0 0\n2 0 0\nkids 0\n";
}

TEST_F(ReadMesh, ReadsAc3dOfAnyVersion) {
  for (const char* head : {"AC3Db", "AC3Dc"}) EXPECT_EQ(bounding_box(read("a.ac", head + ac3d())).max, Vec3(1, 2, 3)) << head;
}

TEST_F(ReadMesh, TellsThatHiddenObjectsAreRead) {
  const std::string one = "1 hidden object is read like the others; delete what does not belong to the shape\n";
  EXPECT_EQ(told("a.ac", "AC3Db" + ac3d()), "");
  EXPECT_EQ(told("a.ac", "AC3Db" + ac3d("name \"hidden\"\n")), "");
  EXPECT_EQ(told("a.ac", "AC3Db" + ac3d("hidden\n")), one);
  std::string scene = skinned_collada();
  EXPECT_EQ(told("a.dae", scene), "");
  const std::string hides = R"(<extra><technique profile="FCOLLADA"><visibility>0</visibility></technique></extra></node>)";
  EXPECT_EQ(told("a.dae", scene.replace(scene.rfind("</node>"), 7, hides)), one);
}

TEST_F(ReadMesh, KnowsMeshesThatStateRas) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_TRUE(read("a.obj", "# 3D Slicer output. SPACE=RAS\n" + triangle).ras);
  EXPECT_FALSE(read("b.obj", "# 3D Slicer output. SPACE=LPS\n" + triangle).ras);
  EXPECT_FALSE(read("c.obj", triangle).ras);
}

TEST_F(ReadMesh, OpensNothingOutsideTheFolderOfAScene) {
  std::filesystem::create_directory(folder_ / "below");
  for (const char* name : {"outside.bin", "below/inside.bin"}) write(name, std::string(240, '\0'));
  std::filesystem::create_symlink("../outside.bin", folder_ / "below" / "link.bin");
  const auto naming = [](const std::string& uri) {
    std::string text = gltf_text();
    return text.replace(text.find("box.bin"), 7, uri);
  };
  expect_error("below/a.gltf", naming("inside.bin"), "no triangles");  // opened; all of its corners are one
  expect_error("a.gltf", naming("below/inside.bin"), "no triangles");
  for (const std::string& uri : {std::string("../outside.bin"), (folder_ / "outside.bin").string(), std::string("link.bin"),
                                 std::string("../below/../outside.bin"), std::string("/dev/zero")}) {
    expect_error("below/a.gltf", naming(uri), "outside its folder");
  }
}

TEST_F(ReadMesh, NamesTheFileThatNamesAnother) {
  std::filesystem::create_directory(folder_ / "sub");
  write("none.bin", "");
  const auto naming = [](const std::string& uri) {
    std::string text = gltf_text();
    return text.replace(text.find("box.bin"), 7, uri);
  };
  expect_error("a.gltf", naming("sub"), "a.gltf: it needs the file 'sub', but that is a directory; put the file in its place");
  expect_error("a.gltf", naming("none.bin"), "a.gltf: it needs the file 'none.bin', but the file is empty; export it again");
}

TEST_F(ReadMesh, SaysInOurWordsWhyAFileCannotBeRead) {
  expect_error("a.gltf", R"({"asset":{"version":"2.0"},})",
               "it stops being JSON in line 1, at ':{\"version\":\"2.0\"},}'; the file is damaged");
  expect_error("a.dae", collada("").substr(0, 500), "a.dae: it cannot be read as COLLADA; it is damaged, or holds");
  expect_error("a.dae", R"(<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset/></COLLADA>)",
               "a.dae: the file holds no triangles");
  expect_error("a.fbx", "Kaydara FBX Binary  ", "a.fbx: it cannot be read as FBX; it is damaged, or holds");
}

TEST_F(ReadMesh, RefusesWhatIsNoMeshFile) {
  const auto message = [](const std::filesystem::path& path) {
    try {
      read_mesh(path);
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string("nothing was thrown");
  };
  EXPECT_THAT(message(folder_ / "missing.off"), testing::HasSubstr("missing.off: there is no such file"));
  EXPECT_EQ(message(""), "the name of a file is empty; name the file to read");
  EXPECT_THAT(message(folder_), testing::HasSubstr("this is a directory"));
  EXPECT_THAT(message("/dev/null"), testing::HasSubstr("not a regular file"));
  expect_error("a.off", "", "the file is empty");
  expect_error("a.stl", "", "the file is empty");
  expect_error("a.xyzzy", "something", "the format '.xyzzy' is not known");
  expect_error("noextension", "something", "is not known");
}

TEST_F(ReadMesh, KnowsOtherFormatsUnderTheNameOfAScene) {
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const char* name : {"a.dae", "a.fbx", "a.3ds", "a.ac"}) EXPECT_EQ(read(name, obj).triangles.size(), 1u) << name;
}

TEST_F(ReadMesh, RefusesMeshesThatAreTooLarge) {
  const std::filesystem::path path = write("a.off", "OFF\n");
  std::filesystem::resize_file(path, (std::uintmax_t{2} << 30) + 1);  // sparse: takes no room
  EXPECT_THROW(read_mesh(path), FileError);
}

}  // namespace
}  // namespace homolog
