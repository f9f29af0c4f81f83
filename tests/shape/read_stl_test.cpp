// SPDX-License-Identifier: MIT
#include "homolog/shape/read_stl.h"

#include <cstring>

#include "shape/files.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

using ReadStl = FileTest;

std::string stl_text(const Mesh& mesh) {
  std::string text = "solid thing\n";
  for (const auto& triangle : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t corner : triangle) {
      const Vec3& v = mesh.vertices[corner];
      text += "vertex " + std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z()) + "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid thing\n";
}

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string stl_bytes(const Mesh& mesh) {
  std::string bytes(80, ' ');
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.f);
    for (const std::uint32_t corner : triangle) {
      for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(mesh.vertices[corner][axis]));
    }
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

const Mesh box = meshes::box({0, 0, 0}, {1, 2, 3});

TEST_F(ReadStl, TextAndBinaryAreWelded) {
  std::string starts_like_text = stl_bytes(box), upper = stl_text(box);
  std::memcpy(starts_like_text.data(), "solid", 5);
  for (char& c : upper) c = static_cast<char>(std::toupper(c));
  for (const std::string& content : {stl_text(box), stl_bytes(box), starts_like_text, upper}) {
    const Mesh mesh = read("a.stl", content);
    EXPECT_EQ(mesh.vertices.size(), 8u);
    EXPECT_EQ(mesh.triangles.size(), 12u);
    EXPECT_NEAR(meshes::volume(mesh), 6, 1e-12);
  }
}

TEST_F(ReadStl, RefusesDamagedBinary) {
  const std::string bytes = stl_bytes(box);
  for (const std::size_t length : {1u, 50u, 83u, 84u, 100u, 683u}) expect_error("a.stl", bytes.substr(0, length), "truncated");
  std::string huge = bytes;
  std::memset(huge.data() + 80, 0xff, 4);
  expect_error("a.stl", huge, "4294967295 triangles are announced");
  std::string not_finite = bytes;
  std::memset(not_finite.data() + 84 + 50 + 12, 0xff, 4);
  expect_error("a.stl", not_finite, "triangle 1: a coordinate is not a finite number");
  expect_error("a.stl", bytes.substr(0, 80) + std::string(4, '\0'), "no triangles");
}

TEST_F(ReadStl, RefusesDamagedText) {
  const std::string text = stl_text(box);
  for (std::size_t length = 6; length + 10 < text.size(); length += 7) expect_error("a.stl", text.substr(0, length), "");
  expect_error("a.stl", "solid nothing\nendsolid nothing\n", "no triangles");
  expect_error("a.stl", "solid x\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendfacet\n", "line 5: a facet has not three vertices");
  expect_error("a.stl", "solid x\nvertex 0 0 zero\n", "line 2: 'zero' is not a finite number");
  expect_error("a.stl", "solid x\nfacade\n", "line 2: the line holds a word");
}

TEST_F(ReadStl, FacetsMayStandInOneLine) {
  std::string text = stl_text(box);
  for (const char* word : {"outer", "vertex", "endloop", "endfacet"}) {
    for (std::size_t at = 0; (at = text.find(std::string("\n") + word, at)) != text.npos;) text[at] = ' ';
  }
  EXPECT_NEAR(meshes::volume(read("a.stl", text)), 6, 1e-12);
  EXPECT_NEAR(meshes::volume(read("b.stl", text + text)), 12, 1e-12) << "two solids, each with a name";
  std::string line = text + text;
  std::replace(line.begin(), line.end(), '\n', ' ');
  EXPECT_NEAR(meshes::volume(read("c.stl", line)), 12, 1e-12) << "all in one line";
}

TEST_F(ReadStl, RefusesToForgetTrianglesThatAreNotCounted) {
  const std::string bytes = stl_bytes(box);
  EXPECT_EQ(read("a.stl", bytes + "7 bytes").triangles.size(), 12u);
  std::string fewer = bytes;
  fewer[80] = 11;
  expect_error("a.stl", fewer, "11 triangles are announced, but the file goes on");
  expect_error("a.stl", bytes + bytes, "12 triangles are announced, but the file goes on");
}

}  // namespace
}  // namespace homolog
