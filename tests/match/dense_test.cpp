// SPDX-License-Identifier: MIT
#include "homolog/match/dense.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "homolog/base/parallel.h"
#include "homolog/match/dense_faults.h"
#include "homolog/match/fill_places.h"
#include "homolog/shape/vertex_normals.h"
#include "match/bent_ball.h"

namespace homolog {
namespace {

using namespace bent_ball;

double mean_error(const DenseMap& map, const Mesh& from, const std::function<Vec3(const Vec3&)>& truth) {
  double sum = 0;
  for (std::size_t i = 0; i < map.places.size(); ++i) sum += (map.places[i].position - truth(from.vertices[i])).norm();
  return sum / static_cast<double>(map.places.size());
}

TEST(DenseMaps, PutTheVerticesOfABallWhereItIsBentTo) {
  const MatchMap match = match_by(bend);
  const DenseMaps maps = dense_maps(match, ball, bent);
  double warped = 0;
  for (const Vec3& vertex : ball.vertices)
    warped += (match.data_from_model(vertex) - bend(vertex)).norm() / static_cast<double>(ball.vertices.size());
  EXPECT_LT(mean_error(maps.data_from_model, ball, bend), 0.8 * warped);
  EXPECT_LT(mean_error(maps.data_from_model, ball, bend), 0.01 * match.data_diagonal);
  for (const DenseMap* map : {&maps.data_from_model, &maps.model_from_data}) {
    EXPECT_EQ(map->placed, map->places.size());
    EXPECT_EQ(map->folded, 0u);
    EXPECT_EQ(map->torn, 0u);
  }
  for (std::size_t i = 0; i < bent.vertices.size(); ++i) {
    const DensePlace& place = maps.model_from_data.places[i];
    EXPECT_LT((bend(place.position) - bent.vertices[i]).norm(), 0.03 * match.data_diagonal);
    EXPECT_GT(place.confidence, 0.5);
  }
}

TEST(DenseMaps, AreMadeOfPlacesOnTheOtherSurface) {
  const DenseMaps maps = dense_maps(match_by(bend), ball, bent);
  for (std::size_t i = 0; i < ball.vertices.size(); ++i) {
    const DensePlace& place = maps.data_from_model.places[i];
    EXPECT_NEAR(place.barycentric.sum(), 1, 1e-12);
    EXPECT_GE(place.barycentric.minCoeff(), 0);
    Vec3 position = Vec3::Zero();
    for (int k = 0; k < 3; ++k) position += place.barycentric[k] * bent.vertices[bent.triangles[place.triangle][k]];
    EXPECT_NEAR((position - place.position).norm(), 0, 1e-12);
    EXPECT_EQ(place.position, maps.laid_vertices[i]);
  }
}

TEST(DenseMaps, DoNotFoldAMirrorImage) {
  const Mesh mirrored = meshes::reversed(moved(ball, mirrored_bend));
  const DenseMaps maps = dense_maps(match_by(mirrored_bend, Chirality::mirrored), ball, mirrored);
  EXPECT_EQ(maps.data_from_model.placed, ball.vertices.size());
  EXPECT_EQ(maps.data_from_model.folded, 0u);
  EXPECT_EQ(maps.model_from_data.folded, 0u);
}

TEST(DenseMaps, HaveNoPlacesOutsideTheCoveredPart) {
  MatchMap match = match_by(bend);
  for (const Vec3& vertex : ball.vertices) {
    match.model.positions.push_back(vertex);
    match.model.weights.push_back(vertex.x() < 0 ? 1 : 0);
    match.data.positions.push_back(bend(vertex));
  }
  match.data.weights = match.model.weights;
  const DenseMaps maps = dense_maps(match, ball, bent);
  for (std::size_t i = 0; i < ball.vertices.size(); ++i) {
    const DensePlace& place = maps.data_from_model.places[i];
    EXPECT_EQ(place.is_there(), ball.vertices[i].x() < 0);
    if (!place.is_there()) EXPECT_EQ(place.confidence, 0);
  }
  for (const DensePlace& place : maps.model_from_data.places) {
    if (place.is_there()) EXPECT_LT(place.position.x(), 0.1);
  }
}

/// Two legs that hang from a bar, `apart` from axis to axis.
Mesh legs(double apart) {
  const double x = apart / 2;
  return fixtures::mesh_of(fixtures::join({fixtures::capsule({-x, 0, 0}, {-x, 1.5, 0}, 0.2), fixtures::capsule({x, 0, 0}, {x, 1.5, 0}, 0.2),
                                           fixtures::capsule({-x, 1.5, 0}, {x, 1.5, 0}, 0.2)}),
                           40);
}

/// How many edges have ends on different legs, below the bar.
std::size_t joined_legs(const Mesh& mesh, const std::function<std::optional<Vec3>(std::size_t)>& place) {
  std::size_t count = 0;
  for (const auto& [a, b] : edges_of(mesh)) {
    const auto at = place(a), bt = place(b);
    count += at && bt && std::max(at->y(), bt->y()) < 1.2 && (at->x() < 0) != (bt->x() < 0);
  }
  return count;
}

TEST(FillPlaces, LeavesNoVertexWithoutOneAndTheOthersAsTheyAre) {
  const MatchMap match = match_by(bend);
  std::vector<DensePlace> places = dense_maps(match, ball, bent).data_from_model.places;
  const std::vector<DensePlace> before = places;
  for (std::size_t i = 0; i < places.size(); i += 3) places[i] = {};
  EXPECT_EQ(fill_places(places, ball, bent, match, Direction::data_from_model), (places.size() + 2) / 3);
  for (std::size_t i = 0; i < places.size(); ++i) {
    ASSERT_TRUE(places[i].is_there());
    EXPECT_LT((places[i].position - before[i].position).norm(), i % 3 == 0 ? 0.05 * match.data_diagonal : 1e-12);
    EXPECT_EQ(places[i].confidence, i % 3 == 0 ? 0 : before[i].confidence);
  }
}

TEST(DenseMaps, NeverTearAVertexFromItsNeighboursToTheNextLimb) {
  const Mesh apart = legs(1), close = legs(0.48);
  // A warp that brings the legs together, but lays the inner side of one within the other.
  const auto shifted = [](const Vec3& x) { return Vec3(0.48 * x.x() + 0.2, x.y(), x.z()); };
  const MatchMap match = match_by(shifted);
  const NearestSurface surface(close, vertex_normals(close));
  const auto nearest = [&](std::size_t i) -> std::optional<Vec3> {
    return surface.nearest(match.data_from_model(apart.vertices[i]), Vec3::Zero(), 1)->position;
  };
  EXPECT_GT(joined_legs(apart, nearest), 10u) << "the nearest place alone would tear";
  const DenseMaps maps = dense_maps(match, apart, close);
  const auto dense = [&](std::size_t i) {
    const DensePlace& place = maps.data_from_model.places[i];
    return place.is_there() ? std::optional(place.position) : std::nullopt;
  };
  EXPECT_EQ(joined_legs(apart, dense), 0u);
  EXPECT_GT(static_cast<double>(maps.data_from_model.placed), 0.9 * static_cast<double>(apart.vertices.size()));
}

TEST(DenseMaps, AreTheSameForAnyNumberOfThreads) {
  const auto positions = [](int threads) {
    const ThreadLimit limit(threads);
    std::vector<Vec3> all;
    const DenseMaps maps = dense_maps(match_by(bend), ball, bent);
    for (const DensePlace& place : maps.model_from_data.places) all.push_back(place.position);
    return all;
  };
  EXPECT_EQ(positions(1), positions(2));
}

TEST(ChanceWithinReach, IsHalfWhereTheExpectedErrorIsTheReach) {
  EXPECT_EQ(chance_within_reach(0), 1);
  EXPECT_DOUBLE_EQ(chance_within_reach(0.05), 0.5);
  EXPECT_NEAR(chance_within_reach(0.05 / 3), 0.84, 0.005);
}

}  // namespace
}  // namespace homolog
