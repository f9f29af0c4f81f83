// SPDX-License-Identifier: MIT
#include "homolog/match/carry_texturing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "match/bent_ball.h"

namespace homolog {
namespace {

using namespace bent_ball;

/// The ball with UVs of each corner of a triangle: uv_of(corner, middle of the triangle).
template <class UvOf>
AttributedMesh textured_ball(const UvOf& uv_of) {
  AttributedMesh mesh;
  mesh.mesh = ball;
  for (const auto& [a, b, c] : ball.triangles) {
    const Vec3 middle = (ball.vertices[a] + ball.vertices[b] + ball.vertices[c]) / 3;
    const auto first = static_cast<std::uint32_t>(mesh.texturing.uvs.size());
    for (const std::uint32_t corner : {a, b, c}) mesh.texturing.uvs.push_back(uv_of(ball.vertices[corner], middle));
    mesh.texturing.corners.push_back({first, first + 1, first + 2});
    mesh.texturing.material_of.push_back(middle.z() > 0 ? 0 : 1);
  }
  mesh.texturing.materials = {{"upper", {}, -1}, {"lower", {}, -1}};
  return mesh;
}

/// Two islands: the upper half to the left, the lower to the right.
Uv halves(const Vec3& x, const Vec3& middle) { return {x.x() / 4.5 + (middle.z() > 0 ? 0.25 : 0.75), x.y() / 4.5 + 0.5}; }

/// One island around the ball, whose two sides meet where y = 0 and x < 0.
Uv around(const Vec3& x, const Vec3& middle) {
  const auto angle = [](const Vec3& p) { return std::atan2(p.y(), p.x()) / (2 * M_PI) + 0.5; };
  const bool pole = std::abs(x.x()) + std::abs(x.y()) < 1e-9, seam = std::abs(x.y()) < 1e-9 && x.x() < 0;
  return {pole ? angle(middle) : seam ? (middle.y() > 0 ? 1.0 : 0.0) : angle(x), (x.z() + 1) / 2};
}

std::array<Uv, 3> uvs_of(const Texturing& texturing, std::size_t t) {
  const auto& [a, b, c] = texturing.corners[t];
  return {texturing.uvs[a], texturing.uvs[b], texturing.uvs[c]};
}

double spread(const std::array<Uv, 3>& uvs) {
  const auto [least, most] = std::minmax({uvs[0][0], uvs[1][0], uvs[2][0]});
  return most - least;
}

const Mesh at_rest = meshes::moved(meshes::sphere(4), fixtures::random_rotation(3));  // which was bent

std::vector<DensePlace> places_on_ball() { return dense_maps(match_by(bend), ball, bent).model_from_data.places; }

TEST(CarryTexturing, KeepsEveryTriangleOnOneIsland) {
  const Texturing texturing = carry_texturing(textured_ball(halves), bent, places_on_ball());
  std::size_t crossing = 0;
  for (std::size_t t = 0; t < bent.triangles.size(); ++t) {
    ASSERT_TRUE(texturing.has_uvs(t));
    const bool left = texturing.material_of[t] == 0;
    bool above = false, below = false;
    for (int k = 0; k < 3; ++k) {
      const Vec3& truth = at_rest.vertices[bent.triangles[t][k]];
      const Uv uv = uvs_of(texturing, t)[k], wanted = halves(truth, {0, 0, left ? 1.0 : -1.0});
      EXPECT_TRUE(left ? uv[0] < 0.5 : uv[0] > 0.5);
      EXPECT_LT(std::hypot(uv[0] - wanted[0], uv[1] - wanted[1]), 0.05);
      (truth.z() > 0 ? above : below) = true;
    }
    crossing += above && below;
  }
  EXPECT_GT(crossing, 50u) << "or the test tests nothing";
}

TEST(CarryTexturing, KeepsAllThatAGltfSaysOfItsMaterials) {
  AttributedMesh giver = textured_ball(halves);
  giver.texturing.gltf = R"({"materials": [{"doubleSided": false, "normalTexture": {"index": 0}}]})";
  giver.texturing.images = {{"normals.png", "PNG"}};
  const Texturing texturing = carry_texturing(giver, bent, places_on_ball());
  EXPECT_EQ(texturing.gltf, giver.texturing.gltf);
  EXPECT_EQ(texturing.images[0].bytes, "PNG");
}

TEST(CarryTexturing, DoesNotStretchATriangleAcrossTheCutOfAnIsland) {
  const Texturing texturing = carry_texturing(textured_ball(around), bent, places_on_ball());
  std::size_t cut = 0;
  for (std::size_t t = 0; t < bent.triangles.size(); ++t) {
    const auto& [a, b, c] = bent.triangles[t];
    const Vec3 middle = (at_rest.vertices[a] + at_rest.vertices[b] + at_rest.vertices[c]) / 3;
    if (std::abs(middle.z()) > 0.8) continue;  // near the poles all of u meets
    EXPECT_LT(spread(uvs_of(texturing, t)), 0.15);
    cut += middle.x() < 0 && std::abs(middle.y()) < 0.03;
  }
  EXPECT_GT(cut, 10u) << "or the test tests nothing";
}

TEST(CarryTexturing, SplitsVerticesAtSeamsAlone) {
  const Texturing texturing = carry_texturing(textured_ball(halves), bent, places_on_ball());
  EXPECT_GT(texturing.uvs.size(), bent.vertices.size());
  EXPECT_LT(static_cast<double>(texturing.uvs.size()), 1.15 * static_cast<double>(bent.vertices.size()));
}

TEST(CarryTexturing, GivesAMeshItsOwnUvsBack) {
  const AttributedMesh giver = textured_ball(around);
  std::vector<DensePlace> places(ball.vertices.size());
  for (std::uint32_t t = 0; t < ball.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) places[ball.triangles[t][k]] = {t, Vec3::Unit(k), ball.vertices[ball.triangles[t][k]], 1};
  }
  const Texturing texturing = carry_texturing(giver, ball, places);
  for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(uvs_of(texturing, t)[k][0], uvs_of(giver.texturing, t)[k][0], 1e-9);
      EXPECT_NEAR(uvs_of(texturing, t)[k][1], uvs_of(giver.texturing, t)[k][1], 1e-9);
    }
  }
}

TEST(CarryTexturing, LeavesTrianglesWithoutAPlaceBare) {
  std::vector<DensePlace> places = places_on_ball();
  places[bent.triangles[7][1]] = {};
  const Texturing texturing = carry_texturing(textured_ball(halves), bent, places);
  EXPECT_FALSE(texturing.has_uvs(7));
  EXPECT_EQ(texturing.material_of[7], -1);
}

TEST(IslandNeighbours, EndAtSeamsAndMaterials) {
  const AttributedMesh mesh = textured_ball(halves);
  const IslandNeighbours neighbours = island_neighbours(mesh);
  std::size_t seams = 0;
  for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
    for (const std::uint32_t next : neighbours.beyond[t]) {
      seams += next == IslandNeighbours::none;
      if (next != IslandNeighbours::none) EXPECT_EQ(mesh.texturing.material_of[next], mesh.texturing.material_of[t]);
    }
  }
  EXPECT_EQ(seams, 2u * 4 * 16) << "the equator of an octahedron divided four times, from both sides";
}

}  // namespace
}  // namespace homolog
