// SPDX-License-Identifier: MIT
// Sec. 6: the family without duplicates, best first, and which hand a match has.
#include "homolog/match/family.h"

#include <gtest/gtest.h>

#include <set>

#include "fixtures/shapes.h"
#include "homolog/match/evidence.h"

namespace homolog {
namespace {

using namespace fixtures;

// A start without pairs, exact but for the cloth's own work.
GrownSet start(const homolog::Similarity& map) {
  GrownSet set;
  set.chirality = map.rotation.determinant() < 0 ? Chirality::mirrored : Chirality::proper;
  set.spline.similarity = map;
  set.spline.affine << map.scale * map.rotation, map.shift;
  return set;
}

GrownSet set_of(std::initializer_list<std::pair<int, int>> pairs, double score, Chirality chirality = Chirality::proper) {
  GrownSet set;
  set.score = score;
  set.chirality = chirality;
  set.spline.affine.col(3) = Vec3(score, 0, 0);  // another map for another score
  for (const auto& [model, data] : pairs) set.pairs.push_back({model, data, {}, {}, 0, 0});
  return set;
}

const Shape& beast() {
  static const Shape shape = described(quadruped());
  return shape;
}

const Mat3 mirror_y = Vec3(1, -1, 1).asDiagonal();

TEST(DistinctSets, ShareAtMostHalfTheirPairsWithABetterOne) {
  const auto better = set_of({{0, 0}, {1, 1}, {2, 2}, {3, 3}}, 5), alike = set_of({{0, 0}, {1, 1}, {2, 2}, {4, 4}}, 4);
  const auto half = set_of({{0, 0}, {1, 1}, {5, 5}, {6, 6}}, 3),
             mirrored = set_of({{0, 0}, {1, 1}, {2, 2}, {3, 3}}, 2, Chirality::mirrored);
  const auto two = set_of({{7, 7}, {8, 8}}, 9);  // a similarity takes three
  const Shape model = bare_shape(std::vector<SalientPoint>(2));
  const std::vector<GrownSet> distinct = distinct_sets({mirrored, half, alike, better, two}, 10, model);
  ASSERT_EQ(distinct.size(), 3u);
  EXPECT_EQ(distinct[0].score, 5);
  EXPECT_EQ(distinct[1].score, 3);
  EXPECT_EQ(distinct[2].score, 2);
  EXPECT_EQ(distinct_sets({mirrored, half, alike, better}, 1, model).size(), 1u);
}

TEST(DistinctSets, OfTheSameMapTheBestStays) {
  GrownSet better = set_of({{0, 0}, {1, 1}, {2, 2}}, 5), same = set_of({{3, 3}, {4, 4}, {5, 5}}, 4);
  same.spline = better.spline;
  const std::vector<GrownSet> distinct = distinct_sets({same, better}, 10, bare_shape(std::vector<SalientPoint>(2)));
  ASSERT_EQ(distinct.size(), 1u);
  EXPECT_EQ(distinct[0].score, 5);
}

TEST(Family, DuplicatesByMapAreOneMatch) {
  const std::vector<GrownSet> sets(3, start({}));
  EXPECT_EQ(make_family(sets, beast(), beast(), coarse(), false).matches.size(), 1u);
}

TEST(Family, AMirrorSymmetricBodyIsAmbiguous) {
  const std::vector<Match> both = make_family({start({}), start({1, mirror_y, Vec3::Zero()})}, beast(), beast(), coarse(), false).matches;
  ASSERT_EQ(both.size(), 2u);
  for (const Match& match : both) EXPECT_EQ(match.handedness, Handedness::ambiguous);
  EXPECT_GT(both[0].similarity.rotation.determinant(), 0);  // of equals the proper one comes first
}

TEST(Family, ConfidencesFallThoughAMirroredMatchIsAShadeBetter) {
  const auto humped = [](double side) { return described(join({quadruped(), ball({0, side * 0.22, 0.05}, 0.1)})); };
  const Shape model = humped(1), data = humped(-1);
  const std::vector<Match> both = make_family({start({}), start({1, mirror_y, Vec3::Zero()})}, model, data, coarse(), false).matches;
  ASSERT_EQ(both.size(), 2u);
  EXPECT_GT(both[0].similarity.rotation.determinant(), 0);
  EXPECT_LT(merit_of(both[0].evidence), merit_of(both[1].evidence));
  EXPECT_GT(both[0].confidence, both[1].confidence);
}

TEST(Family, AWorseWayToLayTheSamePartIsBelievedByTheOddsBetweenThem) {
  const std::vector<Match> ways = make_family({start({}), start({1, mirror_y, Vec3::Zero()})}, beast(), beast(), coarse(), false).matches;
  ASSERT_EQ(ways.size(), 2u);
  const double odds = std::exp(12 * (merit_of(ways[1].evidence) - merit_of(ways[0].evidence)));
  EXPECT_LT(odds, 0.5);
  const double mirror_odds =
      std::exp(12 * (rank_merit(ways[1].evidence, Chirality::mirrored) - rank_merit(ways[0].evidence, Chirality::proper)));
  EXPECT_NEAR(ways[0].confidence, confidence_of(ways[0].evidence, Chirality::proper, 1 + mirror_odds), 1e-12);
  EXPECT_NEAR(ways[1].confidence, odds * confidence_of(ways[1].evidence, Chirality::mirrored, 1 + mirror_odds), 1e-12);
}

TEST(Family, AWayFarBehindOnTheSamePartIsGivenUpUnlessTheBetterOneMayNotBeTold) {
  const Mat3 half_turn = Eigen::AngleAxisd(M_PI, Vec3::UnitZ()).toRotationMatrix();
  Params params = coarse();
  EXPECT_EQ(make_family({start({}), start({1, half_turn, Vec3::Zero()})}, beast(), beast(), params, false).matches.size(), 1u);
  params.match.mirror = Mirror::only;
  const std::vector<GrownSet> sets = {start({}), start({1, half_turn * mirror_y, Vec3::Zero()})};
  EXPECT_EQ(make_family(sets, beast(), beast(), params, false).matches.size(), 1u);
}

TEST(Family, AnotherCopyIsBelievedOnItsOwn) {
  const auto at = [](double x) { return moved(quadruped(), {Mat3::Identity(), 1, {x, 0, 0}}); };
  const Shape two = described(join({quadruped(), at(4)}), 128);
  const std::vector<Match> copies =
      make_family({start({}), start({1, Mat3::Identity(), {4, 0, 0}})}, beast(), two, coarse(), false).matches;
  ASSERT_EQ(copies.size(), 2u);
  for (const Match& match : copies) EXPECT_NEAR(match.confidence, confidence_of(match.evidence, Chirality::proper, 1), 1e-12);
}

TEST(Family, MirrorParameterLeavesOneChirality) {
  const std::vector<GrownSet> sets = {start({}), start({1, mirror_y, Vec3::Zero()})};
  for (const Mirror mirror : {Mirror::forbid, Mirror::only}) {
    Params params = coarse();
    params.match.mirror = mirror;
    const std::vector<Match> matches = make_family(sets, beast(), beast(), params, false).matches;
    ASSERT_EQ(matches.size(), 1u);
    EXPECT_EQ(matches[0].similarity.rotation.determinant() < 0, mirror == Mirror::only);
  }
}

TEST(Family, TheIdentityIsLeftOutOnRequest) {
  const std::vector<Match> matches = make_family({start({}), start({1, mirror_y, Vec3::Zero()})}, beast(), beast(), coarse(), true).matches;
  ASSERT_EQ(matches.size(), 1u);
  EXPECT_LT(matches[0].similarity.rotation.determinant(), 0);
}

TEST(Family, BestFirstOneToOneAndNoLongerThanAsked) {
  const Mat3 turn = Eigen::AngleAxisd(M_PI, Vec3::UnitZ()).toRotationMatrix();
  const std::vector<GrownSet> sets = {start({1, turn, Vec3::Zero()}), start({})};
  const std::vector<Match> matches = make_family(sets, beast(), beast(), coarse(), false).matches;
  ASSERT_FALSE(matches.empty());
  EXPECT_LT((matches[0].data_from_model(Vec3(1, 0, 0.5)) - Vec3(1, 0, 0.5)).norm(), 0.1);  // the head on the head
  std::set<int> model, data;
  for (const Correspondence& c : matches[0].pairs) EXPECT_TRUE(model.insert(c.model).second && data.insert(c.data).second);
  Params params = coarse();
  params.match.matches = 1;
  EXPECT_EQ(make_family(sets, beast(), beast(), params, false).matches.size(), 1u);
}

TEST(Family, FollowedPointsGoOnWithTheNumbersOfTheData) {
  Shape bare = beast();
  bare.points.resize(5);  // the data lost most of its points
  bare.descriptors.resize(5);
  const Family family = make_family({start({})}, beast(), bare, coarse(), false);
  ASSERT_EQ(family.matches.size(), 1u);
  ASSERT_FALSE(family.followed.empty());
  std::size_t next = bare.points.size();
  for (const Correspondence& c : family.matches[0].pairs) {
    if (c.data < 5) continue;
    EXPECT_EQ(c.data, static_cast<int>(next));
    EXPECT_EQ(c.data_point.position, family.followed[next++ - bare.points.size()].position);
    EXPECT_LT((c.data_point.position - c.model_point.position).norm(), 0.03 * beast().diagonal);
  }
  EXPECT_EQ(next - bare.points.size(), family.followed.size());
}

TEST(Family, DataWithTwoPointsIsMatchedByFollowedOnes) {
  Shape bare = beast();  // a plane has as few
  bare.points.resize(2);
  bare.descriptors.resize(2);
  const Family family = make_family({start({})}, beast(), bare, coarse(), false);
  ASSERT_EQ(family.matches.size(), 1u);
  EXPECT_GE(family.matches[0].pairs.size(), 4u);
}

TEST(Family, NoSetsNoFamily) { EXPECT_TRUE(make_family({}, beast(), beast(), coarse(), false).matches.empty()); }

TEST(Handedness, HasAWordForEach) {
  EXPECT_STREQ(handedness_name(Handedness::proper), "proper");
  EXPECT_STREQ(handedness_name(Handedness::mirrored), "mirrored");
  EXPECT_STREQ(handedness_name(Handedness::ambiguous), "ambiguous");
}

}  // namespace
}  // namespace homolog
