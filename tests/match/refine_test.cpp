// SPDX-License-Identifier: MIT
#include "homolog/match/refine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numbers>
#include <optional>

#include "fixtures/shapes.h"
#include "homolog/match/evidence.h"

namespace homolog {
namespace {

using namespace fixtures;

GrownSet start(const homolog::Similarity& map) {
  GrownSet set;
  set.spline.similarity = map;
  set.spline.affine << map.scale * map.rotation, map.shift;
  return set;
}

Refined drawn(const GrownSet& set) {
  Refined refined = lay_set(set, described_hand(), described_hand());
  draw_set(refined, described_hand(), described_hand(), DescriptorKind::free, 0, first_steps);
  return refined;
}

TEST(Refine, AStartThatIsSlightlyOffEndsWithEveryPointAtItself) {
  const Mat3 turn = Eigen::AngleAxisd(0.15, Vec3(1, 1, 1).normalized()).toRotationMatrix();
  Refined refined = drawn(start({1.05, turn, Vec3(0.02, 0, 0)}));
  guide_pairs(refined, described_hand(), described_hand(), DescriptorKind::free);
  ASSERT_EQ(refined.pairs.size(), described_hand().points.size());
  EXPECT_GT(refined.evidence.support, 0.8 * static_cast<double>(described_hand().points.size()));
  for (const Correspondence& c : refined.pairs) EXPECT_EQ(c.model, c.data);
}

// The hand, and where a part of it begins, laid with a stretch; `bend` is what the data did.
struct CutFingers {
  Shape fingers, data;
  std::function<Vec3(const Vec3&)> bend;
  Refined refined;

  explicit CutFingers(std::function<Vec3(const Vec3&)> bent) : bend(std::move(bent)) {
    Mesh mesh = mesh_of(fixtures::hand(), 64);
    fingers = describe_shape(mesh, coarse(), Box{{0, 0.4, 0}, {1, 1, 1}});
    for (Vec3& v : mesh.vertices) v = bend(v);
    data = describe_shape(mesh, coarse());
    refined = lay_set(start({}), fingers, data);
    for (Vec3& node : refined.cloth.nodes) node.y() *= 1.08;
  }
  double mean_error() const {
    double sum = 0;
    for (std::size_t i = 0; i < fingers.body.nodes.size(); ++i) sum += (refined.cloth.nodes[i] - bend(fingers.body.nodes[i])).norm();
    return sum / static_cast<double>(fingers.body.nodes.size()) / fingers.diagonal;
  }
};

// Beyond the cut the data goes on, so the skin alone would not draw a stretched part back.
TEST(Refine, AStretchTowardsACutIsReleased) {
  CutFingers cut([](const Vec3& x) { return Vec3(x.x(), x.y(), x.z() + 0.3 * x.y() * x.y()); });
  guide_pairs(cut.refined, cut.fingers, cut.data, DescriptorKind::free);
  const double drawn = cut.mean_error(), merit = merit_of(cut.refined.evidence);
  finish(cut.refined, cut.fingers, cut.data, DescriptorKind::free);
  EXPECT_LT(cut.mean_error(), 0.9 * drawn);
  EXPECT_EQ(merit_of(cut.refined.evidence), merit);  // the order of matches is left alone
}

// The fingers are folded over by a right angle: where the palm lays them straight, nothing of theirs is near.
TEST(Refine, WhatLiesBeyondAJointIsReachedFromBeforeIt) {
  const auto fold = [](const Vec3& x) {
    const Vec3 joint(0, 0.4, 0);
    const double angle = std::numbers::pi / 2 * std::clamp((x.y() - 0.3) / 0.2, 0.0, 1.0);
    return Vec3(joint + Eigen::AngleAxisd(angle, Vec3::UnitX()) * (x - joint));
  };
  Mesh folded = mesh_of(fixtures::hand(), 64);
  for (Vec3& v : folded.vertices) v = fold(v);
  const Shape &model = described_hand(), data = describe_shape(folded, coarse());
  const Body& body = model.body;
  const auto skin_end = body.nodes.begin() + static_cast<std::ptrdiff_t>(body.surface_count);
  const auto nearer = [&](const Vec3& a, const Vec3& b) { return a.squaredNorm() < b.squaredNorm(); };
  const std::size_t palm = std::min_element(body.nodes.begin(), skin_end, nearer) - body.nodes.begin();
  const auto error_from = [&](std::optional<std::size_t> node) {
    GrownSet set = start({});
    set.drawn_from = node;
    Refined refined = lay_set(set, model, data);
    draw_set(refined, model, data, DescriptorKind::free, 0, first_steps);
    double sum = 0;
    for (std::size_t i = 0; i < body.nodes.size(); ++i) sum += (refined.cloth.nodes[i] - fold(body.nodes[i])).norm();
    return sum / static_cast<double>(body.nodes.size()) / model.diagonal;
  };
  const double at_once = error_from({}), outwards = error_from(palm);
  EXPECT_LT(outwards, 0.025);
  EXPECT_LT(outwards, 0.6 * at_once);
}

TEST(Refine, APartThatDoesNotBendIsLaidBySimilarity) {
  CutFingers cut([](const Vec3& x) { return x; });
  guide_pairs(cut.refined, cut.fingers, cut.data, DescriptorKind::free);
  finish(cut.refined, cut.fingers, cut.data, DescriptorKind::free);
  EXPECT_LT(cut.mean_error(), 0.002);
  EXPECT_EQ(cut.refined.evidence.turning, 0);
}

TEST(Refine, TheMatchTellsItsClothAsASpline) {
  Refined refined = drawn(start({}));
  guide_pairs(refined, described_hand(), described_hand(), DescriptorKind::free);
  const Match match = match_of(refined, described_hand(), described_hand(), coarse());
  for (std::size_t i = 0; i < refined.cloth.nodes.size(); ++i) {
    const double missed = (match.data_from_model(described_hand().body.nodes[i]) - refined.cloth.nodes[i]).norm();
    EXPECT_LT(missed, 0.1 * described_hand().body.spacing);  // nuggets of .02 spacings smooth a little
  }
  EXPECT_EQ(match.handedness, Handedness::proper);
  EXPECT_EQ(match.model_coverage, refined.evidence.model_reached);
  EXPECT_NEAR(match.bending, 0, 1e-9);  // the pairs are the identity, whatever the cloth
  for (const Correspondence& c : match.pairs) EXPECT_GT(c.confidence, 0.9);
}

// The spline's own similarity leaves least bending, but bending makes it smaller.
TEST(Refine, TheSimilarityOfAMatchIsTheNearestToItsMap) {
  const Shape& hand = described_hand();
  Refined refined = lay_set(start({}), hand, hand);
  for (Vec3& node : refined.cloth.nodes) {
    if (node.z() > 0) node.y() += 2 * node.z() * node.z() / hand.diagonal;  // bent
  }
  const Match match = match_of(refined, hand, hand, coarse());
  const auto missed = [&](const homolog::Similarity& s) {
    double sum = 0;
    for (std::size_t i = 0; i < hand.body.surface_count; ++i) sum += (s(hand.body.nodes[i]) - refined.cloth.nodes[i]).squaredNorm();
    return sum;
  };
  EXPECT_LT(missed(match.similarity), missed(match.data_from_model.similarity));
  homolog::Similarity nearby = match.similarity;
  for (const double factor : {0.99, 1.01}) {
    nearby.scale = factor * match.similarity.scale;
    EXPECT_LT(missed(match.similarity), missed(nearby));
  }
}

TEST(Refine, ExtentIsTheSmallerOfMappedModelAndData) {
  Cloth cloth;
  cloth.scale = 0.5;
  EXPECT_DOUBLE_EQ(extent_of(cloth, described_hand(), described_hand()), 0.5 * described_hand().diagonal);
  cloth.scale = 2;
  EXPECT_DOUBLE_EQ(extent_of(cloth, described_hand(), described_hand()), described_hand().diagonal);
}

}  // namespace
}  // namespace homolog
