// SPDX-License-Identifier: MIT
#include "homolog/shape/read_ply.h"

#include <bit>
#include <cstring>

#include "shape/files.h"

namespace homolog {
namespace {

using ReadPly = FileTest;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

const std::vector<Vec3> vertices{{0.1234567890123, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}, {1, 1, -2.5}};
const std::vector<std::vector<std::uint32_t>> faces{{4, 3, 0}, {0, 2, 4, 3}, {1, 2}};

const std::string elements =
    "comment made by hand\nelement vertex 5\nproperty double x\nproperty double y\nproperty double z\nproperty float quality\n"
    "element face 3\nproperty uchar flags\nproperty list uchar int vertex_indices\nproperty list ushort float texcoord\n"
    "element edge 1\nproperty int vertex1\nend_header\n";

template <class T>
std::string bytes(T value, std::endian order) {
  std::string text(sizeof(T), '\0');
  std::memcpy(text.data(), &value, sizeof(T));
  return order == std::endian::native ? text : std::string(text.rbegin(), text.rend());
}

std::string binary_file(std::endian order) {
  std::string file = std::string("ply\nformat binary_") + (order == std::endian::little ? "little" : "big") + "_endian 1.0\n" + elements;
  for (const Vec3& v : vertices) {
    for (int axis = 0; axis < 3; ++axis) file += bytes(v[axis], order);
    file += bytes(std::nanf(""), order);
  }
  for (const auto& face : faces) {
    file += bytes(std::uint8_t{7}, order) + bytes(static_cast<std::uint8_t>(face.size()), order);
    for (const std::uint32_t corner : face) file += bytes(static_cast<std::int32_t>(corner), order);
    file += bytes(std::uint16_t{2}, order) + bytes(0.5f, order) + bytes(0.25f, order);
  }
  return file + bytes(std::int32_t{0}, order);
}

std::string ascii_file() {
  std::string file = "ply\r\nformat ascii 1.0\n" + elements;
  for (const Vec3& v : vertices) {
    char line[100];
    std::snprintf(line, sizeof line, "%.17g %.17g %.17g nan\n", v.x(), v.y(), v.z());
    file += line;
  }
  return file + "7 3 4 3 0 2 .5 .25\n7 4 0 2 4 3 0\n7 2 1 2 0\n0\n";
}

TEST_F(ReadPly, AllEncodingsGiveTheSameMesh) {
  for (const std::string& file : {ascii_file(), binary_file(std::endian::little), binary_file(std::endian::big)}) {
    const Mesh mesh = read("a.ply", file);
    EXPECT_EQ(mesh.vertices, vertices);
    ASSERT_EQ(mesh.triangles.size(), 3u);
    EXPECT_EQ(mesh.triangles[0], (std::array<std::uint32_t, 3>{4, 3, 0}));
  }
}

TEST_F(ReadPly, AnyTypeCanHoldAnything) {
  const std::string header =
      "element vertex 3\nproperty short z\nproperty char y\nproperty uint16 x\nelement face 1\nproperty list int8 float32 "
      "vertex_index\nend_header\n";
  const std::vector<Vec3> expected{{1, -2, -300}, {60000, 0, 0}, {0, 5, 7}};
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    std::string file = std::string("ply\nformat binary_") + (order == std::endian::little ? "little" : "big") + "_endian 1.0\n" + header;
    for (const Vec3& v : expected) {
      file += bytes(static_cast<std::int16_t>(v.z()), order) + bytes(static_cast<std::int8_t>(v.y()), order) +
              bytes(static_cast<std::uint16_t>(v.x()), order);
    }
    file += bytes(std::int8_t{3}, order) + bytes(2.f, order) + bytes(0.f, order) + bytes(1.f, order);
    const Mesh mesh = read("a.ply", file);
    EXPECT_EQ(mesh.vertices, expected);
    EXPECT_EQ(mesh.triangles, (Triangles{{2, 0, 1}}));
  }
}

TEST_F(ReadPly, RefusesEveryTruncation) {
  for (const std::string& file : {ascii_file(), binary_file(std::endian::little), binary_file(std::endian::big)}) {
    for (std::size_t length = 1; length + 2 < file.size(); length += 3) expect_error("a.ply", file.substr(0, length), "");
  }
}

TEST_F(ReadPly, RefusesDamagedHeaders) {
  const std::string start = "ply\nformat ascii 1.0\n", xyz = "property float x\nproperty float y\nproperty float z\n";
  expect_error("a.ply", "plx\n", "line 1: this is not a PLY file");
  expect_error("a.ply", "ply\nformat utf8 1.0\nend_header\n", "line 2: the format is neither");
  expect_error("a.ply", "ply\nend_header\n", "no format line");
  expect_error("a.ply", start + "element \x1b[2J 1\nend_header\n", "element ?[2J has no properties");  // no commands for the terminal
  expect_error("a.ply", start + "element vertex 3\n", "ends inside its header");
  expect_error("a.ply", start + "element vertex -3\nend_header\n", "line 3: the number of an element is negative");
  expect_error("a.ply", start + "element vertex many\nend_header\n", "line 3: 'many' is not a whole number");
  expect_error("a.ply", start + "element vertex 4000000000\n" + xyz + "end_header\n0 0 0\n", "too short");
  expect_error("a.ply", start + "element vertex 9223372036854775807\n" + xyz + "end_header\n0 0 0\n", "too short");
  expect_error("a.ply", start + "element vertex 4000000000\nend_header\n0 0 0\n", "no properties");
  expect_error("a.ply", start + "element vertex 1\nproperty quad x\nend_header\n0\n", "line 4: the header names a type");
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";  // without, it would be a cloud
  expect_error("a.ply", start + "element vertex 1\nproperty float x\n" + face + "end_header\n0\n3 0 0 0\n", "properties x, y and z");
  expect_error("a.ply", start + "element vertex 1\n" + xyz + "property list float int a\nend_header\n0 0 0 0\n", "whole-number type");
  expect_error("a.ply", start + "elephant 3\nend_header\n", "line 3: the header has a line that PLY does not know");
  expect_error("a.ply", start + "property float x\nend_header\n", "line 3: the header has a line that PLY does not know");
}

TEST_F(ReadPly, RefusesDamagedBodies) {
  const std::string start =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  EXPECT_EQ(read("a.ply", start + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2").triangles, (Triangles{{0, 1, 2}}));
  expect_error("a.ply", start + "0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n", "line 11: 'inf' is not a finite number");
  expect_error("a.ply", start + "0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "line 11: a property is missing");
  expect_error("a.ply", start + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 13: vertex 3 does not exist");
  expect_error("a.ply", start + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "line 13: vertex -1 does not exist");
  expect_error("a.ply", start + "0 0 0\n1 0 0\n0 1 0\n3 0 1 0.5\n", "line 13: vertex 0.5 does not exist");
  expect_error("a.ply", start + "0 0 0\n1 0 0\n0 1 0\n9999999 0 1 2\n", "line 13: a list of 9999999 items does not fit");
  expect_error("a.ply", start + "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", "line 13: a list of -3 items does not fit");
  expect_error("a.ply", start + "0 0 0\n1 0 0\n0 1 0\n0     \n", "no triangles");
  expect_error("a.ply",
               "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
               "property list uchar int corners\nend_header\n0 0 0\n1 0\n",
               "have no list vertex_indices");
  std::string file = binary_file(std::endian::little);
  const double not_finite = INFINITY;
  std::memcpy(file.data() + file.find("end_header\n") + 11 + 28, &not_finite, sizeof(double));
  expect_error("a.ply", file, "vertex 1: a coordinate is not a finite number");
}

}  // namespace
}  // namespace homolog
