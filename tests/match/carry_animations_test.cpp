// SPDX-License-Identifier: MIT
#include "homolog/match/carry_animations.h"

#include <gtest/gtest.h>

#include "fixtures/skinned_capsule.h"
#include "fixtures/solids.h"
#include "homolog/match/carry_attributes.h"
#include "homolog/outputs/attributes_gltf.h"
#include "homolog/shape/read_gltf_attributes.h"

namespace homolog {
namespace {

/// A capsule that bends and walks, and another one, bound in another pose and place, three times as large.
struct Walkers {
  AttributedMesh giver;
  Mesh receiver;
  std::vector<DensePlace> places;
  Mat3 turn = fixtures::random_rotation(7);
  Chirality chirality;

  Vec3 place_of(const Vec3& x) const { return 3 * (turn * x) + Vec3(5, 1, -20); }

  explicit Walkers(Chirality is) : chirality(is) {
    if (is == Chirality::mirrored) turn = turn * fixtures::mirror_x();
    giver.mesh = capsule::mesh();
    giver.rig = capsule::rig_of(giver.mesh);
    giver.shape_keys = {capsule::nose_of(giver.mesh)};
    giver.animations = {{"walk", {0, 1}, {}, {{0, 1}}}};
    std::vector<Pose> first = capsule::bend_of(giver.rig, -0.5), second = capsule::bend_of(giver.rig, 0.9);
    second[0].shift += Vec3(0.3, 2, -1);
    second[0].turn = second[0].turn * Eigen::AngleAxisd(0.8, Vec3(1, 2, 3).normalized());
    second[1].shift += Vec3(0, 0, 0.2);
    second[1].scale = {1, 1.2, 1};
    giver.animations[0].poses = {{first[0], second[0]}, {first[1], second[1]}};
    receiver = giver.mesh;
    receiver.vertices = capsule::bent(giver.mesh, giver.rig, 0.6);
    for (Vec3& vertex : receiver.vertices) vertex = place_of(vertex);
    places.resize(receiver.vertices.size());
    for (std::uint32_t t = 0; t < giver.mesh.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        DensePlace& place = places[giver.mesh.triangles[t][k]];
        place.triangle = t;
        place.barycentric = Vec3::Unit(k);
        place.position = giver.mesh.vertices[giver.mesh.triangles[t][k]];
      }
    }
  }

  /// How far the receiver is at most from the giver, moved to where the receiver is, at a time; in shares of its length.
  double apart(const Animation& carried, const Rig& rig, std::size_t time) const {
    const auto at = [&](const Animation& animation) { return std::vector<Pose>{animation.poses[0][time], animation.poses[1][time]}; };
    const std::vector<Vec3> is = capsule::posed(receiver, rig, at(carried)),
                            wanted = capsule::posed(giver.mesh, giver.rig, at(giver.animations[0]));
    double most = 0;
    for (std::size_t i = 0; i < is.size(); ++i) most = std::max(most, (is[i] - place_of(wanted[i])).norm());
    return most / (3 * 2 * (capsule::half + capsule::radius));
  }
};

void expect_same_walk(Chirality chirality) {
  const Walkers walkers(chirality);
  const GiverPlaces places{walkers.places, chirality};
  const Rig rig = carry_rig(walkers.giver, walkers.receiver, places);
  const std::vector<Animation> carried = carry_animations(walkers.giver, walkers.receiver, places, rig);
  ASSERT_EQ(carried.size(), 1u);
  EXPECT_EQ(carried[0].name, "walk");
  EXPECT_EQ(carried[0].weights, walkers.giver.animations[0].weights);
  for (const std::size_t time : {0, 1}) EXPECT_LT(walkers.apart(carried[0], rig, time), 0.04) << "although it was bound in another pose";
  std::vector<Animation> still = carried;
  still[0].poses = {{pose_of(local_bind(rig, 0)), {}}, {pose_of(local_bind(rig, 1)), {}}};
  EXPECT_GT(walkers.apart(still[0], rig, 0), 0.3) << "or the test tests nothing";
}

TEST(CarryAnimations, MovesAPosedCapsuleAsTheOtherOne) { expect_same_walk(Chirality::proper); }

TEST(CarryAnimations, MovesAMirroredOneAsAMirrorShows) { expect_same_walk(Chirality::mirrored); }

AttributedMesh read_glb(const std::string& glb) {
  return read_gltf_attributes(
      glb, "a.glb", [](const std::string&) -> std::optional<std::string> { return {}; }, 1'000'000);
}

TEST(CarryAnimations, ShowsWhatARigBelowAScaledArmatureDoes) {
  Walkers walkers(Chirality::proper);
  const capsule::SkinnedFile file;
  const AttributedMesh giver = read_glb(file.glb());
  for (std::size_t i = 0; i < walkers.receiver.vertices.size(); ++i)
    walkers.receiver.vertices[i] = walkers.place_of(file.shown.vertices[i]);
  const AttributedMesh carried = carry_attributes(giver, walkers.receiver, walkers.places, Chirality::proper);
  const AttributedMesh again = read_glb(attributes_gltf(carried, "b.glb", "a.glb")[0].contents);
  ASSERT_EQ(giver.animations.size(), 1u);
  ASSERT_EQ(again.animations.size(), 1u);
  const std::vector<Pose> end{again.animations[0].poses[0].back(), again.animations[0].poses[1].back()};
  const std::vector<Vec3> is = capsule::posed(again.mesh, again.rig, end), wanted = capsule::bent(file.shown, file.rig, 1);
  ASSERT_EQ(is.size(), wanted.size());
  double most = 0;
  for (std::size_t i = 0; i < is.size(); ++i) {
    EXPECT_LT((again.mesh.vertices[i] - walkers.receiver.vertices[i]).norm(), 1e-4) << "it stands where it stood";
    most = std::max(most, (is[i] - walkers.place_of(wanted[i])).norm());
  }
  EXPECT_LT(most, 0.01 * bounding_box(walkers.receiver).diagonal());
}

}  // namespace
}  // namespace homolog
