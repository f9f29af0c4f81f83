// SPDX-License-Identifier: MIT
#include "homolog/match/carry_rig.h"

#include <gtest/gtest.h>

#include "fixtures/capsule.h"
#include "homolog/match/carry_attributes.h"
#include "match/bent_ball.h"

namespace homolog {
namespace {

constexpr double scale = 3;
const double size = scale * 2 * (capsule::half + capsule::radius);  // of the receiver

/// Turned, three times as large, a little bent, and half as thick again in one direction.
Vec3 warp(const Vec3& x) {
  return scale * (fixtures::random_rotation(7) * Vec3(x.x(), x.y() + 0.06 * x.x() * x.x(), 1.3 * x.z())) + Vec3(5, 1, -20);
}
Vec3 mirrored_warp(const Vec3& x) { return warp(fixtures::mirror_x() * x); }

/// Turned, three times as large, and bent to an arc, which turns the tip by 18 degrees but stretches nothing by more than 7 %.
Vec3 arc(const Vec3& x) {
  constexpr double bow = 6;
  const Vec3 on_arc((bow - x.y()) * std::sin(x.x() / bow), bow - (bow - x.y()) * std::cos(x.x() / bow), x.z());
  return scale * (fixtures::random_rotation(7) * on_arc) + Vec3(5, 1, -20);
}
Vec3 mirrored_arc(const Vec3& x) { return arc(fixtures::mirror_x() * x); }

using Warp = Vec3 (*)(const Vec3&);

/// The rig carried to a warped capsule of other triangles, and what it should be.
struct Carried {
  Mesh at_rest = capsule::mesh(fixtures::random_rotation(3)), receiver;  // which was warped
  AttributedMesh giver;
  DenseMap map;
  Chirality chirality;

  explicit Carried(Warp to, Chirality is) : receiver(bent_ball::moved(at_rest, to)), chirality(is) {
    giver.mesh = capsule::mesh();
    giver.rig = capsule::rig_of(giver.mesh);
    giver.shape_keys = {capsule::nose_of(giver.mesh)};
    MatchMap match = bent_ball::match_by([&](const Vec3& x) { return to(2 * x); }, chirality);
    for (Vec3& centre : match.data_from_model.centres) centre *= 2;  // right at places of the cube from -2 to 2
    map = dense_maps(scaled(match), giver.mesh, receiver).model_from_data;
  }

  /// The spline of y = 2 x as one of y.
  static MatchMap scaled(MatchMap match) {
    match.data_from_model.affine.leftCols<3>() /= 2;
    for (Vec3& weight : match.data_from_model.weights) weight /= 2;
    match.scale /= 2;
    match.model_diagonal *= 2;
    return match;
  }
};

struct Differences {
  double mean = 0, most = 0;
};
Differences differences(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  Differences result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    result.mean += (a[i] - b[i]).norm() / static_cast<double>(a.size());
    result.most = std::max(result.most, (a[i] - b[i]).norm());
  }
  return result;
}

/// What an artist who rigged the receiver by hand would have made.
Rig true_rig(const Carried& carried, Warp to) {
  Rig rig = capsule::rig_of(carried.at_rest);
  for (Joint& joint : rig.joints) {
    const Vec3 place = joint.bind.topRightCorner<3, 1>();
    Mat3 gradient;
    for (int k = 0; k < 3; ++k) gradient.col(k) = (to(place + 1e-4 * Vec3::Unit(k)) - to(place - 1e-4 * Vec3::Unit(k))) / 2e-4;
    Mat3 turn = nearest_turn(gradient, carried.chirality).rotation * joint.bind.topLeftCorner<3, 3>();
    if (carried.chirality == Chirality::mirrored) turn.col(0) *= -1;
    joint.bind = capsule::frame(turn, to(place));
  }
  return rig;
}

void expect_same_bend(const Carried& carried, Warp to) {
  const Rig rig = carry_rig(carried.giver, carried.receiver, {carried.map.places, carried.chirality}), truth = true_rig(carried, to);
  for (int i = 0; i < 2; ++i) {
    EXPECT_LT((rig.joints[i].bind - truth.joints[i].bind).topRightCorner(3, 1).norm(), 0.02 * size);
    const Mat3 turn = rig.joints[i].bind.topLeftCorner<3, 3>();
    EXPECT_TRUE((turn.transpose() * turn).isIdentity(1e-9));
    EXPECT_NEAR(turn.determinant(), 1, 1e-9);
    EXPECT_LT(Eigen::AngleAxisd(Mat3(turn.transpose() * truth.joints[i].bind.topLeftCorner<3, 3>())).angle(), 0.1);
  }
  EXPECT_EQ(rig.joints[1].parent, 0);
  for (const double angle : {-1.0, 1.0}) {
    const Differences apart = differences(capsule::bent(carried.receiver, rig, angle), capsule::bent(carried.receiver, truth, angle));
    const Differences bend = differences(carried.receiver.vertices, capsule::bent(carried.receiver, truth, angle));
    EXPECT_LT(apart.mean, 0.01 * size);
    EXPECT_LT(apart.most, 0.03 * size);
    EXPECT_GT(bend.most, 0.4 * size) << "or the test tests nothing";
  }
}

TEST(CarryRig, BendsAWarpedCapsuleAsItsOwnRigWould) { expect_same_bend(Carried(warp, Chirality::proper), warp); }

TEST(CarryRig, BendsAMirroredCapsuleAsAMirrorShows) { expect_same_bend(Carried(mirrored_warp, Chirality::mirrored), mirrored_warp); }

TEST(CarryRig, LeavesTheReceiverAsItIsAtRest) {
  const Carried carried(warp, Chirality::proper);
  const Rig rig = carry_rig(carried.giver, carried.receiver, {carried.map.places, carried.chirality});
  EXPECT_LT(differences(capsule::bent(carried.receiver, rig, 0), carried.receiver.vertices).most, 1e-5 * size);
}

TEST(CarryRig, GivesEveryVertexWeightsOfSumOne) {
  Carried carried(warp, Chirality::proper);
  for (std::size_t i = 0; i < carried.map.places.size(); ++i) {
    if (carried.at_rest.vertices[i].x() > 0.5) carried.map.places[i] = {};  // not covered
  }
  carried.receiver = meshes::joined(carried.receiver, meshes::moved(meshes::sphere(1), 0.1 * Mat3::Identity(), warp({0.4, 0.6, 0})));
  carried.map.places.resize(carried.receiver.vertices.size());  // a button, not covered either
  const Rig rig = carry_rig(carried.giver, carried.receiver, {carried.map.places, carried.chirality});
  for (const Influences& influences : rig.influences) {
    float sum = 0;
    for (const Influence& influence : influences) {
      EXPECT_GE(influence.weight, 0);
      sum += influence.weight;
    }
    EXPECT_NEAR(sum, 1, 1e-6);
  }
  for (std::size_t i = 0; i < carried.at_rest.vertices.size(); ++i) {
    if (carried.at_rest.vertices[i].x() > 0.5) EXPECT_EQ(rig.influences[i][0].joint, 1) << "as the nearest one that is covered";
  }
  const Influences& button = rig.influences.back();
  for (std::size_t i = carried.at_rest.vertices.size(); i < rig.influences.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(rig.influences[i][k].weight, button[k].weight) << "it moves as a whole";
  }
}

TEST(CarryRig, KeepsMoreThanFourWeightsAVertexWhereTheGiverHasThem) {
  Carried carried(warp, Chirality::proper);
  carried.giver.rig.joints.resize(6, carried.giver.rig.joints[1]);
  const Influences six = strongest_influences({{0, 6}, {1, 5}, {2, 4}, {3, 3}, {4, 2}, {5, 1}}, 8);
  for (Influences& influences : carried.giver.rig.influences) influences = six;
  const Rig rig = carry_rig(carried.giver, carried.receiver, {carried.map.places, carried.chirality});
  for (std::size_t k = 0; k < six.size(); ++k) {
    EXPECT_EQ(rig.influences[7][k].joint, six[k].joint);
    EXPECT_NEAR(rig.influences[7][k].weight, six[k].weight, 1e-6);
  }
}

void expect_same_nose(const Carried& carried, Warp to) {
  const auto keys = carry_shape_keys(carried.giver, carried.receiver, {carried.map.places, carried.chirality});
  ASSERT_EQ(keys.size(), 1u);
  EXPECT_EQ(keys[0].name, "nose");
  EXPECT_EQ(keys[0].weight, 0.25);
  const ShapeKey at_rest = capsule::nose_of(carried.at_rest);
  std::vector<Vec3> truth, moved;
  double length = 0;
  for (std::size_t i = 0; i < carried.receiver.vertices.size(); ++i) {
    const Vec3& x = carried.at_rest.vertices[i];
    truth.push_back(to(x + at_rest.displacements[i]) - to(x));
    length = std::max(length, truth.back().norm());
  }
  const Differences apart = differences(keys[0].displacements, truth);
  EXPECT_LT(apart.most, 0.1 * length);
  EXPECT_LT(apart.mean, 0.03 * length);
  EXPECT_GT(length, 0.9);
}

TEST(CarryShapeKeys, DrawsTheSameNoseOnAWarpedCapsule) { expect_same_nose(Carried(arc, Chirality::proper), arc); }

TEST(CarryShapeKeys, DrawsItMirroredOnAMirroredOne) { expect_same_nose(Carried(mirrored_arc, Chirality::mirrored), mirrored_arc); }

TEST(CarryShapeKeys, FadeWhereNothingIsCovered) {
  Carried carried(warp, Chirality::proper);
  for (std::size_t i = 0; i < carried.map.places.size(); ++i) {
    if (carried.at_rest.vertices[i].x() > 1.5) carried.map.places[i] = {};
  }
  const ShapeKey key = carry_shape_keys(carried.giver, carried.receiver, {carried.map.places, carried.chirality}).front();
  for (std::size_t i = 0; i < carried.map.places.size(); ++i) {
    if (carried.at_rest.vertices[i].x() > 1.8) EXPECT_TRUE(key.displacements[i].isZero());
    EXPECT_LT(key.displacements[i].norm(), 1.2);
  }
}

TEST(CarryAttributes, CarriesRigAndShapeKeysToo) {
  const Carried carried(warp, Chirality::proper);
  const AttributedMesh all = carry_attributes(carried.giver, carried.receiver, carried.map.places, carried.chirality);
  EXPECT_EQ(all.rig.joints.size(), 2u);
  EXPECT_EQ(all.rig.influences.size(), carried.receiver.vertices.size());
  EXPECT_EQ(all.shape_keys.size(), 1u);
  EXPECT_EQ(told_attributes(all), "weights of 2 joints, 1 shape key");
}

TEST(NearestPlaced, GoesAlongTheSurface) {
  const Mesh mesh = meshes::joined(meshes::box({0, 0, 0}, {1, 1, 1}), meshes::box({5, 5, 5}, {6, 6, 6}));
  std::vector<DensePlace> places(mesh.vertices.size());
  places[0].triangle = 0;
  const NearestPlaced nearest = nearest_placed(mesh, places);
  EXPECT_EQ(nearest.vertex[0], 0u);
  EXPECT_EQ(nearest.vertex[1], 0u);
  EXPECT_DOUBLE_EQ(nearest.distance[1], 1);
  EXPECT_EQ(nearest.vertex[8], NearestPlaced::none);
}

}  // namespace
}  // namespace homolog
