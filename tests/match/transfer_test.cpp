// SPDX-License-Identifier: MIT
#include "homolog/match/transfer.h"

#include <gtest/gtest.h>

#include "fixtures/solids.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

/// Even places in the cube from -1 to 1.
std::vector<Vec3> lattice(int count) {
  std::vector<Vec3> points;
  for (int i = 0; i < count * count * count; ++i) {
    points.push_back(2.0 / (count - 1) * Vec3(i % count, i / count % count, i / count / count) - Vec3::Ones());
  }
  return points;
}

Vec3 bend(const Vec3& x) { return 3 * (fixtures::random_rotation(7) * Vec3(x.x(), x.y() + 0.3 * x.x() * x.x(), x.z())) + Vec3(5, 1, -20); }

/// A spline through the bent lattice; its part x < 0 is covered.
MatchMap bent_match() {
  const std::vector<Vec3> sources = lattice(6);
  std::vector<Vec3> targets;
  for (const Vec3& x : sources) targets.push_back(bend(x));
  MatchMap match;
  match.data_from_model =
      ThinPlateSpline::similarity_free(SourceSystem(sources, std::vector<double>(sources.size(), 0)), targets, Chirality::proper);
  match.scale = match.data_from_model.similarity.scale;
  match.model_diagonal = 2 * std::sqrt(3.0);
  match.data_diagonal = 3 * match.model_diagonal;
  match.model.positions = lattice(12);
  for (const Vec3& x : match.model.positions) {
    match.model.weights.push_back(x.x() < 0 ? 1 : 0);
    match.data.positions.push_back(bend(x));
  }
  match.data.weights = match.model.weights;
  return match;
}

const MatchMap match = bent_match();
const std::vector<Vec3> inside{{-0.5, 0.3, 0.2}, {-0.9, -0.7, 0.1}, {-0.33, 0.1, -0.8}};

TEST(CarryPoints, PutsThemWhereTheMapDoes) {
  const auto carried = carry_points(match, inside, Direction::data_from_model);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    EXPECT_TRUE(carried[i].is_there());
    EXPECT_NEAR((carried[i].position - bend(inside[i])).norm(), 0, 0.02 * match.data_diagonal);
    EXPECT_EQ(carried[i].position, match.data_from_model(inside[i]));
    EXPECT_GT(carried[i].coverage.value(), 0.9);
  }
}

TEST(CarryPoints, KnowsThatWhatIsEndlesslyFarIsNotCovered) {
  for (const Direction direction : {Direction::data_from_model, Direction::model_from_data}) {
    const CarriedPoint far = carry_points(match, {Vec3(1e300, 0, 0)}, direction)[0];
    EXPECT_EQ(far.coverage, 0);
    EXPECT_FALSE(far.is_there());
  }
}

TEST(CarriedTriangles, KeepTheOuterSideOutsideAlsoWhereTheMapMirrors) {
  const Mesh ball = meshes::sphere(2);
  for (const bool mirrored : {false, true}) {
    MatchMap map;
    map.data_from_model.affine.leftCols<3>() = mirrored ? Mat3(2 * fixtures::mirror_x()) : Mat3(2 * Mat3::Identity());
    map.data_from_model.affine.col(3).setZero();
    Mesh carried{{}, carried_triangles(map, ball)};
    for (const CarriedPoint& point : carry_points(map, ball.vertices, Direction::data_from_model))
      carried.vertices.push_back(point.position);
    EXPECT_NEAR(meshes::volume(carried), 8 * meshes::volume(ball), 1e-9) << mirrored;
  }
}

TEST(CarryPoints, BringsThemBack) {
  std::vector<Vec3> there;
  for (const CarriedPoint& point : carry_points(match, inside, Direction::data_from_model)) there.push_back(point.position);
  const auto back = carry_points(match, there, Direction::model_from_data);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    EXPECT_TRUE(back[i].is_there());
    EXPECT_NEAR((back[i].position - inside[i]).norm(), 0, 1e-7);
  }
}

TEST(CarryPoints, TellsWhatIsOutsideTheCoveredPart) {
  const auto carried = carry_points(match, {{0.5, 0.3, 0.2}, {-0.5, 0.3, 40}}, Direction::data_from_model);
  EXPECT_FALSE(carried[0].is_there());
  EXPECT_LT(carried[0].coverage.value(), 0.1);
  EXPECT_FALSE(carried[1].is_there()) << "far from the shape, though its nearest sample is covered";
  EXPECT_EQ(carried[1].coverage.value(), 0);
}

TEST(CarryPoints, CoversNothingOutsideTheBoxOfWhatWasDescribed) {
  const Vec3 inside(-0.5, 0.3, 0.2), beyond = inside + Vec3(0, 0.01, 0);
  MatchMap cut = match;
  cut.model.box = Box{Vec3(-1, -1, -1), Vec3(1, 0.305, 1)};
  const auto whole = carry_points(match, {inside, beyond}, Direction::data_from_model),
             carried = carry_points(cut, {inside, beyond}, Direction::data_from_model);
  EXPECT_TRUE(whole[0].is_there() && whole[1].is_there());
  EXPECT_EQ(carried[0].coverage, whole[0].coverage);
  EXPECT_EQ(carried[1].coverage.value(), 0);
}

TEST(CarryPoints, WithoutSamplesSaysNothingOfCoverage) {
  MatchMap bare = match;
  bare.model = {};
  const CarriedPoint point = carry_points(bare, {{0.5, 0.3, 0.2}}, Direction::data_from_model)[0];
  EXPECT_FALSE(point.coverage);
  EXPECT_TRUE(point.is_there());
}

TEST(CarryPoints, ExpectsErrorsInTheUnitOfTheShapeCarriedTo) {
  const double there = carry_points(match, inside, Direction::data_from_model)[0].expected_error;
  const double back = carry_points(match, {match.data_from_model(inside[0])}, Direction::model_from_data)[0].expected_error;
  EXPECT_NEAR(there / back, match.scale, 1e-6 * match.scale);
}

TEST(InverseAt, SaysWhereAFoldedMapHasNone) {
  ThinPlateSpline fold;  // (x, y, z) -> (x / 5 + |(x, y, z)|, y, z), which never goes far to the left
  fold.affine.row(0) << 0.2, 0, 0, 0;
  fold.centres = {{0, 0, 0}};
  fold.weights = {{1, 0, 0}};
  EXPECT_FALSE(inverse_at(fold, images_of_centres(fold), 1, {-0.5, 0.1, 0}).exact);
  const InversePlace place = inverse_at(fold, images_of_centres(fold), 1, {1.5, 0.1, 0});
  EXPECT_TRUE(place.exact);
  EXPECT_NEAR(fold(place.position).x(), 1.5, 1e-8);
}

TEST(CarryPoints, ExpectsLessNearPairs) {
  MatchMap paired = match;
  paired.known = {{inside[0], 0.95}, {inside[1], 0.6}};
  const auto without = carry_points(match, inside, Direction::data_from_model);
  const auto with = carry_points(paired, inside, Direction::data_from_model);
  for (std::size_t i : {0, 1, 2}) EXPECT_LT(with[i].expected_error, without[i].expected_error / (i == 0 ? 4 : 1));
  const double back = carry_points(paired, {match.data_from_model(inside[0])}, Direction::model_from_data)[0].expected_error;
  EXPECT_NEAR(with[0].expected_error / back, match.scale, 1e-6 * match.scale);
}

TEST(DoubtAt, IsTheLeastOfThePairs) {
  const std::vector<KnownPlace> known{{{0, 0, 0}, 0.9}, {{1, 0, 0}, 0.6}};
  const auto at = [&](double x) { return doubt_at(known, {x, 0, 0}, 10); };
  EXPECT_LT(at(0), at(1)) << "a surer pair";
  EXPECT_LT(at(0), at(-1));
  EXPECT_EQ(at(-1), doubt_at({known[0]}, {-1, 0, 0}, 10));
  EXPECT_EQ(at(1.2), doubt_at({known[1]}, {1.2, 0, 0}, 10));
  EXPECT_EQ(doubt_at({}, {0, 0, 0}, 10), doubt_at(known, {1e6, 0, 0}, 10));
  EXPECT_EQ(doubt_at({{{0, 0, 0}, 0}}, {0, 0, 0}, 10), doubt_at({}, {0, 0, 0}, 10)) << "a pair that is surely wrong";
}

TEST(ExpectedError, GrowsWithDoubtAndWhereTheMapIsFarFromAnySimilarity) {
  const Mat3 turn = fixtures::random_rotation(3), mirror = fixtures::mirror_x();
  const double least = expected_error_share(turn, 0.1);
  EXPECT_NEAR(expected_error_share(7 * turn * mirror, 0.1), least, 1e-6);
  EXPECT_NEAR(expected_error_share(turn, 0.3), 3 * least, 1e-9);
  const Mat3 stretched = turn * Vec3(1, 1, 2).asDiagonal(), squeezed = turn * Vec3(1, 1, 0.5).asDiagonal();
  EXPECT_GT(expected_error_share(stretched, 0.1), 2 * least);
  EXPECT_NEAR(expected_error_share(stretched, 0.1), expected_error_share(squeezed, 0.1), 1e-9);
  EXPECT_TRUE(std::isfinite(expected_error_share(Mat3::Zero(), 0.1))) << "a map that is flat";
}

}  // namespace
}  // namespace homolog
