// SPDX-License-Identifier: MIT
#include "homolog/outputs/morph.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "fixtures/solids.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

/// A ball far away that becomes an egg.
Morph egg() {
  Morph morph{meshes::moved(meshes::sphere(3), Mat3::Identity(), {1e5, -2e4, 30}), {}};
  morph.start.vertices.push_back({1e5, 0, 0});  // of no triangle
  for (const Vec3& vertex : morph.start.vertices) morph.end.push_back(vertex + Vec3(0, 0, 0.5 * std::max(0.0, vertex.z() - 30)));
  return morph;
}

/// A GLB taken apart by the book, apart from the writer.
struct Glb {
  nlohmann::json json;
  std::string bytes;

  explicit Glb(const std::string& file) {
    EXPECT_EQ(file.substr(0, 4), "glTF");
    EXPECT_EQ(word(file, 4), 2u);
    EXPECT_EQ(word(file, 8), file.size());
    const std::uint32_t size = word(file, 12);
    json = nlohmann::json::parse(file.substr(20, size));
    EXPECT_EQ(file.substr(20 + size + 4, 4), std::string("BIN\0", 4));
    bytes = file.substr(20 + size + 8);
    EXPECT_EQ(bytes.size(), word(file, 20 + size));
  }

  static std::uint32_t word(const std::string& text, std::size_t place) {
    std::uint32_t value;
    std::memcpy(&value, text.data() + place, 4);
    return value;
  }

  std::vector<float> floats(int accessor) const {
    const auto& view = json["bufferViews"][json["accessors"][accessor]["bufferView"].get<int>()];
    std::vector<float> values(view["byteLength"].get<std::size_t>() / 4);
    std::memcpy(values.data(), bytes.data() + view["byteOffset"].get<std::size_t>(), 4 * values.size());
    return values;
  }
};

TEST(MorphGlb, HoldsTheStartAndTheWayToTheEnd) {
  const Morph morph = egg();
  const Glb glb(morph_glb(morph, {}));
  const auto& primitive = glb.json["meshes"][0]["primitives"][0];
  const auto start = glb.floats(primitive["attributes"]["POSITION"]), way = glb.floats(primitive["targets"][0]["POSITION"]);
  const auto origin = glb.json["nodes"][0]["translation"].get<std::array<double, 3>>();
  ASSERT_EQ(start.size(), 3 * morph.start.vertices.size());
  for (std::size_t i = 0; i < start.size(); ++i) {
    EXPECT_NEAR(origin[i % 3] + start[i], morph.start.vertices[i / 3][i % 3], 1e-2 * (i / 3 + 1 == morph.end.size()) + 1e-6);
    EXPECT_NEAR(origin[i % 3] + start[i] + way[i], morph.end[i / 3][i % 3], 1e-2 * (i / 3 + 1 == morph.end.size()) + 1e-6);
  }
}

TEST(MorphGlb, AnimatesTheWeightOfItsOneTarget) {
  const Glb glb(morph_glb(egg(), {}));
  const auto& animation = glb.json["animations"][0];
  EXPECT_EQ(animation["channels"][0]["target"]["path"], "weights");
  EXPECT_EQ(glb.floats(animation["samplers"][0]["input"]), (std::vector<float>{0, 2, 4}));
  EXPECT_EQ(glb.floats(animation["samplers"][0]["output"]), (std::vector<float>{0, 1, 0}));
}

TEST(MorphGlb, HasUnitNormalsEverywhere) {
  const Glb glb(morph_glb(egg(), {}));
  const auto normals = glb.floats(glb.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"]);
  for (std::size_t i = 0; i < normals.size(); i += 3) EXPECT_NEAR(std::hypot(normals[i], normals[i + 1], normals[i + 2]), 1, 1e-5);
}

TEST(FrameOf, GoesStraightFromTheStartToTheEnd) {
  const Morph morph = egg();
  EXPECT_EQ(frame_of(morph, 0).vertices, morph.start.vertices);
  EXPECT_EQ(frame_of(morph, 1).vertices, morph.end);
  EXPECT_NEAR((frame_of(morph, 0.5).vertices[7] - (morph.start.vertices[7] + morph.end[7]) / 2).norm(), 0, 1e-9);
  EXPECT_EQ(frame_of(morph, 0.5).triangles, morph.start.triangles);
}

TEST(MakeMorph, BeginsWithTheModelLaidByTheSimilarity) {
  const Mesh model = meshes::sphere(1);
  MatchMap match;
  match.similarity.topLeftCorner<3, 3>() = 2 * fixtures::random_rotation(3);
  match.similarity.topRightCorner<3, 1>() = Vec3(7, 8, 9);
  DenseMaps maps;
  maps.laid_vertices = model.vertices;
  const Morph morph = make_morph(match, model, maps);
  EXPECT_NEAR((morph.start.vertices[3] - (2 * (fixtures::random_rotation(3) * model.vertices[3]) + Vec3(7, 8, 9))).norm(), 0, 1e-12);
  EXPECT_EQ(morph.end, model.vertices);
}

TEST(MakeMorph, ShowsTheOuterSideOfAMirroredMatch) {
  const Mesh model = meshes::sphere(2);
  MatchMap match;
  match.data_from_model.affine.setZero();
  match.data_from_model.affine.leftCols<3>() = fixtures::mirror_x();
  match.similarity.topLeftCorner<3, 3>() = fixtures::mirror_x();
  DenseMaps maps;
  for (const Vec3& vertex : model.vertices) maps.laid_vertices.push_back(fixtures::mirror_x() * vertex);
  const Morph morph = make_morph(match, model, maps);
  for (const double share : {0.0, 0.5, 1.0}) EXPECT_NEAR(meshes::volume(frame_of(morph, share)), meshes::volume(model), 1e-9);
}

}  // namespace
}  // namespace homolog
