// SPDX-License-Identifier: MIT
#include "homolog/outputs/misplaced.h"

#include "fixtures/shapes.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

using testing::HasSubstr;

const CoveredSamples& samples() {
  static const CoveredSamples samples{positions_of(fixtures::described_hand().surface), {}};
  return samples;
}

std::optional<Misplaced> in_place(const Mesh& mesh, const CoveredSamples& samples = homolog::samples()) {
  return misplaced(mesh, "given.ply", {"hand.off", samples, fixtures::described_hand().diagonal});
}

TEST(Misplaced, WelcomesOtherTessellationsPartsAndMore) {
  const Mesh coarse = fixtures::mesh_of(fixtures::hand(), 32);
  EXPECT_FALSE(in_place(coarse));
  Mesh part = coarse;
  part.triangles.resize(part.triangles.size() / 5);
  EXPECT_FALSE(in_place(part));
  const Box box = bounding_box(coarse);
  const Vec3 size = box.max - box.min;
  EXPECT_FALSE(in_place(meshes::joined(coarse, meshes::moved(coarse, Mat3::Identity(), 2 * size))));
}

TEST(Misplaced, SaysHowAMeshIsTurnedAndScaled) {
  const Mesh hand = fixtures::mesh_of(fixtures::hand(), 48);
  const Mat3 z_up = Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX()).toRotationMatrix();
  const auto turned = in_place(meshes::moved(hand, z_up)), scaled = in_place(meshes::moved(hand, 1000 * Mat3::Identity())),
             both = in_place(meshes::moved(hand, 0.01 * z_up)), far = in_place(meshes::moved(hand, z_up, Vec3(500, 0, 0)));
  ASSERT_TRUE(turned && scaled && both && far);
  EXPECT_EQ(turned->sentence,
            "given.ply: it does not lie where hand.off lay when that was matched, but would if turned from Z up to Y up; save it with the "
            "axes and in the unit of that one");
  EXPECT_THAT(scaled->sentence, HasSubstr("would if scaled by 0.001;"));
  EXPECT_THAT(both->sentence, HasSubstr("would if turned from Z up to Y up and scaled by 100;"));
  EXPECT_THAT(far->sentence, HasSubstr("was matched; save"));
  EXPECT_TRUE(turned->explained && scaled->explained && both->explained && !far->explained);
}

TEST(Misplaced, KnowsThatSamplesOfThickenedSurfacesLieOffThem) {
  const double diagonal = fixtures::described_hand().diagonal;
  CoveredSamples off = samples();
  for (std::size_t i = 0; i < off.positions.size(); ++i) off.positions[i] += 0.05 * diagonal * fixtures::described_hand().surface[i].normal;
  const Mesh hand = fixtures::mesh_of(fixtures::hand(), 48);
  EXPECT_TRUE(misplaced(hand, "given.ply", {"hand.off", off, diagonal}));
  EXPECT_FALSE(misplaced(hand, "given.ply", {"hand.off", off, diagonal, 0.1}));
}

TEST(Misplaced, TellsASmallPartFromTheWholeInAnotherUnit) {
  const Vec3 tip = samples().positions[0];
  CoveredSamples about_tip = samples();
  for (Vec3& position : about_tip.positions) position -= tip;
  const Mesh hand = meshes::moved(fixtures::mesh_of(fixtures::hand(), 48), Mat3::Identity(), -tip);
  const auto wrong = in_place(meshes::moved(hand, 0.001 * Mat3::Identity()), about_tip);
  ASSERT_TRUE(wrong);
  EXPECT_THAT(wrong->sentence, HasSubstr("would if scaled by 1000;"));
  const double size = 0.01 * fixtures::described_hand().diagonal;
  EXPECT_FALSE(in_place(meshes::box(Vec3::Zero(), Vec3::Constant(size)), about_tip));
}

TEST(Misplaced, SaysNothingWhereTheShapeIsNotKnown) {
  EXPECT_FALSE(in_place(meshes::box(Vec3(1e6, 0, 0), Vec3(2e6, 1, 1)), {}));
  EXPECT_EQ(misplaced_points({Vec3(1e6, 0, 0)}, "given.csv", {"a", {}, 1}), "");
}

TEST(MisplacedPoints, AreMostlyFarOrAllInOnePlace) {
  const double diagonal = fixtures::described_hand().diagonal;
  const auto asked = [&](const std::vector<Vec3>& points) {
    return misplaced_points(points, "given.csv", {"hand.off", samples(), diagonal});
  };
  const Vec3 tip = samples().positions[0], other = samples().positions[1], far = 100 * tip + Vec3(100, 0, 0);
  EXPECT_EQ(asked({}), "");
  EXPECT_EQ(asked({tip, far}), "");
  EXPECT_EQ(asked({tip, far, far}),
            "2 of 3 points of given.csv are farther from hand.off than a tenth of its diagonal; are they in its coordinates and its unit?");
  EXPECT_EQ(asked({tip, tip + 0.005 * diagonal * Vec3::UnitX(), tip}),
            "the 3 points of given.csv lie within 0.5 % of the diagonal of hand.off; are they in its coordinates and its unit?");
  EXPECT_EQ(asked({tip, tip}), "") << "two landmarks may lie beside each other";
  EXPECT_EQ(asked({tip, tip, other}), "");
}

}  // namespace
}  // namespace homolog
