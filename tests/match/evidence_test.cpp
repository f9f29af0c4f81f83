// SPDX-License-Identifier: MIT
// Evidence tells a right map from flipped, shrunk and torn ones, which the paper's one-sided distance cannot.
#include "homolog/match/evidence.h"

#include <gtest/gtest.h>

#include "fixtures/shapes.h"

namespace homolog {
namespace {

Cloth laid(const Similarity& map) {
  ThinPlateSpline spline;
  spline.similarity = map;
  spline.affine << map.scale * map.rotation, map.shift;
  return lay_cloth(fixtures::described_hand().body, spline, map.rotation.determinant() < 0 ? Chirality::mirrored : Chirality::proper);
}

Evidence weigh_on_itself(const Cloth& cloth) { return weigh(cloth, fixtures::described_hand(), fixtures::described_hand()); }

double reached_on_itself(const Cloth& cloth) { return data_reached(cloth, fixtures::described_hand(), fixtures::described_hand()); }

Mat3 half_turn() { return Eigen::AngleAxisd(M_PI, Vec3::UnitY()).toRotationMatrix(); }

TEST(Evidence, TheIdentityReachesAllWithoutStretch) {
  const Evidence evidence = weigh_on_itself(laid({}));
  EXPECT_EQ(evidence.model_reached, 1);
  EXPECT_GT(reached_on_itself(laid({})), 0.95);  // four times as many samples there; few stand on edges with other normals
  EXPECT_GT(evidence.data_near_reached, 0.95);
  EXPECT_NEAR(evidence.turning, 0, 1e-6);
}

TEST(Evidence, FlippedAndShrunkMapsReachLess) {
  const Evidence right = weigh_on_itself(laid({}));
  const Similarity flip{1, half_turn(), Vec3::Zero()}, shrink{0.5, Mat3::Identity(), Vec3::Zero()};
  const Evidence flipped = weigh_on_itself(laid(flip)), shrunk = weigh_on_itself(laid(shrink));
  EXPECT_LT(flipped.model_reached, 0.7);
  EXPECT_LT(reached_on_itself(laid(flip)), 0.7);
  EXPECT_LT(reached_on_itself(laid(shrink)), 0.3);  // the covered skin is a quarter at most
  EXPECT_NEAR(shrunk.turning, 0, 1e-6);
  EXPECT_LT(merit_of(flipped), merit_of(right) - 0.5);
  EXPECT_LT(merit_of(shrunk), merit_of(right) - 0.5);
}

TEST(Evidence, InsideOutIsNotReached) {
  Cloth cloth = laid({});
  for (Mat3& rotation : cloth.rotations) rotation = -rotation;
  EXPECT_LT(weigh_on_itself(cloth).model_reached, 0.01);
}

TEST(Evidence, TurningIsTheMeanAngleBetweenNeighbours) {
  const Body& body = fixtures::described_hand().body;
  Cloth cloth = laid({});
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    cloth.rotations[i] = Eigen::AngleAxisd(0.5 * body.nodes[i].x(), Vec3::UnitZ()).toRotationMatrix();
  }
  double sum = 0, edges = 0;
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    for (const int j : body.neighbours[i]) sum += 0.5 * std::abs(body.nodes[i].x() - body.nodes[j].x()), ++edges;
  }
  EXPECT_GT(sum, 0);
  EXPECT_NEAR(weigh_on_itself(cloth).turning, sum / edges, 1e-6);
}

TEST(Evidence, APartIsJudgedByTheDataNearIt) {
  Shape with_stranger = fixtures::described_hand();
  with_stranger.diagonal = 5;
  for (const SurfaceSample& s : fixtures::described_hand().surface) with_stranger.surface.push_back({s.position + Vec3(5, 0, 0), s.normal});
  with_stranger.surface_blocks = make_blocks(with_stranger.surface);
  const Evidence alone = weigh_on_itself(laid({}));
  const Evidence evidence = weigh(laid({}), fixtures::described_hand(), with_stranger);
  EXPECT_NEAR(data_reached(laid({}), fixtures::described_hand(), with_stranger), 0.5 * reached_on_itself(laid({})), 1e-9);
  EXPECT_NEAR(evidence.data_near_reached, alone.data_near_reached, 1e-9);
}

TEST(Evidence, MeritAndConfidenceRiseTogether) {
  const Evidence middling{0.7, 0.7, 0.2, 5, 0.2, 0.2, 0.1};
  Evidence better_reach = middling, less_turning = middling, more_pairs = middling, same_ways = middling, as_thick = middling,
           same_ends = middling;
  better_reach.data_near_reached = 0.8;
  less_turning.turning = 0.1;
  more_pairs.support = 8;
  same_ways.ways_changed = 0.1;
  as_thick.thickness_changed = 0.1;
  same_ends.ends_missed = 0.02;
  for (const Evidence& better : {better_reach, less_turning, more_pairs, same_ways, as_thick, same_ends}) {
    EXPECT_GT(merit_of(better), merit_of(middling));
    EXPECT_GT(confidence_of(better, Chirality::proper, 1), confidence_of(middling, Chirality::proper, 1));
  }
  EXPECT_GT(confidence_of({1, 1, 0, 10, 0, 0, 0}, Chirality::proper, 1), 0.9);
  EXPECT_LT(confidence_of({}, Chirality::proper, 1), 0.01);
  EXPECT_LT(confidence_of(middling, Chirality::proper, 2), confidence_of(middling, Chirality::proper, 1));
}

TEST(Evidence, AMirroredMatchMustBeBetterToBeAsCredible) {
  const Evidence evidence{0.7, 0.7, 0.2, 5, 0.2, 0.2, 0.1};
  Evidence better = evidence;
  better.turning = 0;
  EXPECT_LT(rank_merit(evidence, Chirality::mirrored), rank_merit(evidence, Chirality::proper));
  EXPECT_LT(confidence_of(evidence, Chirality::mirrored, 1), confidence_of(evidence, Chirality::proper, 1));
  EXPECT_GT(confidence_of(better, Chirality::mirrored, 1), confidence_of(evidence, Chirality::proper, 1));
}

// A bar in a longer one: its ends are cuts, for the longer one goes on there. A bar beside it is not excused.
TEST(Evidence, CutFacesInsideTheDataDoNotCount) {
  const Shape piece = fixtures::described(fixtures::cylinder({-1, 0, 0}, {1, 0, 0}, 0.4));
  const Shape bar = fixtures::described(fixtures::cylinder({-3, 0, 0}, {3, 0, 0}, 0.4), 96);
  const Evidence inside = weigh(lay_cloth(piece.body, {}, Chirality::proper), piece, bar);
  EXPECT_GT(inside.model_reached, 0.9);       // the two ends are 17 % of its skin; all but their rims is excused
  EXPECT_GT(inside.data_near_reached, 0.75);  // near along the inside goes on for a fifth of its length at either end
  Cloth beside = lay_cloth(piece.body, {}, Chirality::proper);
  for (Vec3& node : beside.nodes) node.z() += 2;
  EXPECT_EQ(weigh(beside, piece, bar).model_reached, 0);
}

// The arm of an L that stands close to the piece is far away along the inside.
TEST(Evidence, NearMeansNearAlongTheInside) {
  const fixtures::Solid piece = fixtures::capsule({0, 0, 0}, {0, 0, 2}, 0.2);
  const fixtures::Solid hook =
      fixtures::join({piece, fixtures::capsule({0, 0, 2}, {0, 0, 4}, 0.2), fixtures::capsule({0, 0, 4}, {0.55, 0, 4}, 0.2),
                      fixtures::capsule({0.55, 0, 4}, {0.55, 0, 0}, 0.2)});
  const Shape model = fixtures::described(piece), data = fixtures::described(hook, 128);
  const Evidence evidence = weigh(lay_cloth(model.body, {}, Chirality::proper), model, data);
  EXPECT_GT(evidence.data_near_reached, 0.75);  // half of what is near through the air is the other arm
}

TEST(Evidence, NothingReachesNothing) {
  EXPECT_EQ(weigh(laid({}), fixtures::described_hand(), {}).model_reached, 0);
  EXPECT_EQ(data_reached(laid({}), fixtures::described_hand(), {}), 0);
}

}  // namespace
}  // namespace homolog
