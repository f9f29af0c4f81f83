// SPDX-License-Identifier: MIT
#include <Eigen/LU>

#include "fixtures/capsule.h"
#include "fuzz/target.h"
#include "homolog/outputs/attributes_gltf.h"
#include "homolog/shape/read_gltf.h"
#include "homolog/shape/read_gltf_attributes.h"

namespace homolog::fuzz {
namespace {

/// A small mesh with everything.
std::string seed(const char* name) {
  AttributedMesh mesh;
  mesh.mesh = meshes::box({0, 0, 0}, {1, 1, 1});
  mesh.rig = capsule::rig_of(mesh.mesh);
  mesh.shape_keys = {capsule::nose_of(mesh.mesh)};
  mesh.colours.assign(8, {1, 0, 0, 1});
  mesh.texturing = {{{0, 0}, {1, 0}, {0, 1}}, {12, {0, 1, 2}},        std::vector<int>(12, 0),
                    {{"m", {1, 1, 1, 1}, 0}}, {{"p.png", "\x89PNG"}}, ""};
  return attributes_gltf(mesh, name, "seed").front().contents;
}

constexpr std::size_t most_triangles = 10000;

std::string found_beside(const std::string&) { return std::string(4096, '\1'); }

Mesh read_mesh_alone(const std::string& bytes, const std::string& file) { return read_gltf(bytes, file, found_beside, most_triangles); }

Mesh read_mesh_of_attributes(const std::string& bytes, const std::string& file) {
  const AttributedMesh mesh = read_gltf_attributes(bytes, file, found_beside, most_triangles);
  const std::size_t vertices = mesh.mesh.vertices.size(), triangles = mesh.mesh.triangles.size();
  require(mesh.colours.empty() || mesh.colours.size() == vertices, "every vertex has a colour, or none");
  require(mesh.rig.joints.empty() || mesh.rig.influences.size() == vertices, "every vertex has influences, or none");
  for (const Influences& influences : mesh.rig.influences) {
    for (const Influence& influence : influences) require(influence.joint < mesh.rig.joints.size(), "joints exist");
  }
  for (const Joint& joint : mesh.rig.joints) require(joint.bind.inverse().allFinite(), "joints are bound in frames with inverses");
  for (const Vec3& vertex : mesh.mesh.vertices) require(vertex.allFinite(), "vertices are finite, wherever joints put them");
  for (const ShapeKey& key : mesh.shape_keys) require(key.displacements.size() == vertices, "keys have all displacements");
  const Texturing& texturing = mesh.texturing;
  require(texturing.corners.empty() || texturing.corners.size() == triangles, "every triangle has corners, or none");
  for (const auto& corners : texturing.corners) {
    for (const std::uint32_t corner : corners) require(corner == Texturing::no_uv || corner < texturing.uvs.size(), "UVs exist");
  }
  for (const Material& material : texturing.materials) {
    require(material.image < static_cast<int>(texturing.images.size()), "images exist");
  }
  return mesh.mesh;
}

}  // namespace

Target gltf() {
  return {
      "gltf",
      {seed("a.glb"), seed("a.gltf"),
       // skinned below a turned and scaled node, by joints that are not bound where they stand, a target applied
       R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"scale":[0.01,0.01,0.01],"rotation":[1,0,0,1],"children":[1,2]},)"
       R"({"mesh":0,"skin":0,"weights":[1]},{"translation":[1,2,3],"children":[3]},{"scale":[0,1,1]}],"skins":[{"joints":[2,3]}],)"
       R"("meshes":[{"primitives":[{"mode":5,"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2},"targets":[{"POSITION":0}]}]}],)"
       R"("accessors":[{"bufferView":0,"componentType":5120,"count":4,"type":"VEC3"},{"bufferView":0,"componentType":5121,"count":4,)"
       R"("type":"VEC4"},{"bufferView":0,"componentType":5121,"normalized":true,"count":4,"type":"VEC4"}],"bufferViews":[{"buffer":0,)"
       R"("byteLength":48}],"buffers":[{"uri":"data:;base64,AAAAAQAAAAEBAQAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA",)"
       R"("byteLength":48}]})",
       R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}],)"
       R"("meshes":[{"primitives":[{"mode":5,"attributes":{"POSITION":0},"targets":[{"POSITION":1}]}]}],"accessors":[{"bufferView":0,)"
       R"("componentType":5120,"count":4,"type":"VEC3"},{"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1,"indices":)"
       R"({"bufferView":0,"componentType":5121},"values":{"bufferView":0}}}],"bufferViews":[{"buffer":0,"byteLength":48}],)"
       R"("buffers":[{"uri":"data:;base64,AAAAAQAAAAEBAQAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA","byteLength":48}]})"},
      [](const std::string& bytes) {
        run_mesh_reader(read_mesh_of_attributes, bytes);
        run_mesh_reader(read_mesh_alone, bytes);
      }};
}

}  // namespace homolog::fuzz
