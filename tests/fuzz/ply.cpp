// SPDX-License-Identifier: MIT
#include <array>

#include "fuzz/target.h"
#include "homolog/shape/read_ply.h"
#include "homolog/shape/read_ply_attributes.h"

namespace homolog::fuzz {
namespace {

const std::string header =
    "element vertex 3\nproperty char x\nproperty short y\nproperty uint z\nproperty uchar red\nelement face 1\n"
    "property list uchar int vertex_indices\nelement edge 1\nproperty list ushort double weights\nend_header\n";

std::string number(std::size_t size, unsigned value, bool little) {
  std::string bytes(size, '\0');
  bytes[little ? 0 : size - 1] = static_cast<char>(value);
  return bytes;
}

std::string binary(bool little) {
  std::string bytes = std::string("ply\nformat binary_") + (little ? "little" : "big") + "_endian 1.0\ncomment small\n" + header;
  const unsigned vertices[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 7}};
  for (const auto& [x, y, z] : vertices) {
    bytes += number(1, x, little) + number(2, y, little) + number(4, z, little) + number(1, 255, little);
  }
  bytes += number(1, 3, little) + number(4, 0, little) + number(4, 1, little) + number(4, 2, little);
  return bytes + number(2, 1, little) + std::string(8, '\x40');
}

/// Beside the mesh there is a number for every vertex, or none.
Mesh read_mesh_of_attributes(const std::string& bytes, const std::string& file) {
  const AttributedMesh mesh = read_ply_attributes(bytes, file, [](const std::string&) { return std::optional<std::string>("picture"); });
  for (const Field& field : mesh.fields) require(field.values.size() == mesh.mesh.vertices.size(), "a field has a value for every vertex");
  require(mesh.texturing.corners.empty() || mesh.texturing.corners.size() == mesh.mesh.triangles.size(), "all triangles are laid, or none");
  require(mesh.colours.empty() || mesh.colours.size() == mesh.mesh.vertices.size(), "every vertex has a colour, or none");
  return mesh.mesh;
}

}  // namespace

Target ply() {
  return {
      "ply",
      {"ply\nformat ascii 1.0\n" + header + "0 0 0 255\n1 0 0 255\n0 1 7 nan\n3 0 1 2\n2 .5 1e300\n", binary(true), binary(false),
       "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float32 x\nproperty float64 y\nproperty list int8 uint8 z\n"
       "end_header\n",
       "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty "
       "ushort green\nproperty float blue\nproperty int part\nproperty double depth\nend_header\n0 0 0 1 2 3 4 nan\n1 1 1 5 6 7 -8 9\n",
       "ply\nformat ascii 1.0\ncomment TextureFile a b.png\ncomment TextureFile c.png\nelement vertex 4\nproperty float x\nproperty "
       "float y\nproperty float z\nelement face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\nproperty "
       "int texnumber\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty int part\nproperty float depth\nend_header\n"
       "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 8 0 0 1 0 1 1 0 1 1 9 9 9 5 .5\n3 0 1 3 6 0 0 1 0 0 1 -1 1 2 3 4 nan\n",
       "ply\nformat ascii 1.0\nelement \x1b[2J 1\nend_header\n",
       "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 2 3\n"},
      [](const std::string& bytes) {
        run_mesh_reader(read_ply, bytes);
        run_mesh_reader(read_mesh_of_attributes, bytes);
      }};
}

}  // namespace homolog::fuzz
