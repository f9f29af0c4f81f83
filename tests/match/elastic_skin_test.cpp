// SPDX-License-Identifier: MIT
#include "homolog/match/elastic_skin.h"

#include <gtest/gtest.h>

#include "fixtures/solids.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

const Mesh sphere = meshes::sphere(3);
const fixtures::Similarity turn{fixtures::random_rotation(5), 3, {10, -20, 5}};

std::vector<Vec3> turned(const std::vector<Vec3>& vertices) {
  std::vector<Vec3> result;
  for (const Vec3& vertex : vertices) result.push_back(turn(vertex));
  return result;
}

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

Pull none(const Mesh& mesh) {
  return {std::vector<Vec3>(mesh.vertices.size(), Vec3::Zero()), std::vector<double>(mesh.vertices.size(), 0)};
}

TEST(ElasticSkin, StaysWhenNothingPulls) {
  const std::vector<Vec3> positions = turned(sphere.vertices);
  EXPECT_LT(farthest(ElasticSkin(sphere, 3, Chirality::proper).drawn(positions, none(sphere), 1), positions), 1e-3);
}

TEST(ElasticSkin, FollowsAFewVerticesAsAWhole) {
  const std::vector<Vec3> positions = turned(sphere.vertices);
  Pull pull = none(sphere);
  const Vec3 shift(0.3, 0, 0.1);
  for (std::size_t i = 0; i < positions.size(); i += 5) {
    pull.targets[i] = positions[i] + shift;
    pull.weights[i] = 1;
  }
  const auto drawn = ElasticSkin(sphere, 3, Chirality::proper).drawn(positions, pull, 3);
  for (std::size_t i = 0; i < drawn.size(); ++i) EXPECT_LT((drawn[i] - positions[i] - shift).norm(), 0.01);
}

TEST(ElasticSkin, SmoothsWhatNoiseAsksFor) {
  const std::vector<Vec3> positions = turned(sphere.vertices);
  Pull pull{positions, std::vector<double>(positions.size(), 1)};
  for (std::size_t i = 0; i < positions.size(); ++i) pull.targets[i] += 0.2 * (i % 2 == 0 ? 1 : -1) * Vec3::UnitX();
  const auto drawn = ElasticSkin(sphere, 3, Chirality::proper).drawn(positions, pull, 2);
  EXPECT_LT(farthest(drawn, positions), 0.1);
}

TEST(ElasticSkin, MayBeAMirrorImage) {
  std::vector<Vec3> positions;
  for (const Vec3& vertex : sphere.vertices) positions.push_back(3 * (fixtures::mirror_x() * vertex));
  EXPECT_LT(farthest(ElasticSkin(sphere, 3, Chirality::mirrored).drawn(positions, none(sphere), 1), positions), 1e-3);
}

TEST(ElasticSkin, TakesVerticesWithoutTrianglesAndTwins) {
  Mesh mesh = sphere;
  mesh.vertices.push_back({7, 7, 7});              // of no triangle
  mesh.vertices.push_back(mesh.vertices.front());  // a seam
  Pull pull = none(mesh);
  const std::size_t lone = mesh.vertices.size() - 2, twin = lone + 1;
  pull.targets[lone] = {8, 7, 7};
  pull.weights[lone] = 1;
  const auto drawn = ElasticSkin(mesh, 1, Chirality::proper).drawn(mesh.vertices, pull, 1);
  EXPECT_NEAR((drawn[lone] - Vec3(8, 7, 7)).norm(), 0, 1e-3);
  EXPECT_EQ(drawn[twin], drawn[0]);
}

}  // namespace
}  // namespace homolog
