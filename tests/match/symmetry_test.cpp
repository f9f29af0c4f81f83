// SPDX-License-Identifier: MIT
#include "homolog/match/symmetry.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "fixtures/solids.h"
#include "homolog/outputs/symmetry_text.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

const Mat3 turn = fixtures::random_rotation(5);
const Vec3 shift(3, -1, 8);

/// A body of two different balls on an axis, and a pair of equal ones at their sides; bent: one of these is higher.
Mesh body(double bent) {
  const auto ball = [](double radius, const Vec3& place) { return meshes::moved(meshes::sphere(4), radius * Mat3::Identity(), place); };
  Mesh mesh = meshes::joined(ball(1, {0, 0, 0}), ball(0.6, {0, 0, 1.7}));
  for (const double side : {-1.0, 1.0}) mesh = meshes::joined(mesh, ball(0.4, {1.5 * side, 0.3, side > 0 ? bent : 0}));
  return meshes::moved(mesh, turn, shift);
}

/// What a match by this similarity says of the body.
Symmetry symmetry_of(const Mesh& mesh, const Similarity& similarity) {
  Match match;
  match.similarity = similarity;
  match.data_from_model.affine.leftCols<3>() = similarity.scale * similarity.rotation;
  match.data_from_model.affine.col(3) = similarity.shift;
  Shape shape;
  shape.diagonal = bounding_box(mesh).diagonal();
  const PartWeights all{std::vector<float>(mesh.vertices.size(), 1), {}};
  return symmetries_of({mesh, shape}, {match}, {{all, all}}).front();
}

/// Reflects the body in its own plane, a little wrongly.
Similarity rough_mirror() {
  const Mat3 mirror = turn * fixtures::mirror_x() * turn.transpose(), wrong = Eigen::AngleAxisd(0.05, Vec3::UnitZ()).toRotationMatrix();
  return {0.97, wrong * mirror, shift - 0.97 * (wrong * mirror * shift) + Vec3(0.05, 0.1, 0)};
}

TEST(BestMirrorPlane, IsThePlaneOfAReflection) {
  const Plane plane{Vec3(1, 2, -2) / 3, 0.7};
  std::vector<WeighedPair> pairs;
  for (const Vec3& x : meshes::box({0, 1, 2}, {4, 2, 3}).vertices) pairs.push_back({x, reflected(plane, x), 1 + x.x()});
  const Plane found = best_mirror_plane(pairs);
  EXPECT_NEAR(std::abs(found.normal.dot(plane.normal)), 1, 1e-12);
  EXPECT_NEAR(found.normal.dot(plane.normal) * found.offset, plane.offset, 1e-12);
  EXPECT_GT(found.normal.cwiseAbs().maxCoeff(), 0);
}

TEST(SymmetriesOf, FindsTheMirrorPlaneExactly) {
  const Symmetry symmetry = symmetry_of(body(0), rough_mirror());
  ASSERT_TRUE(symmetry.mirror.has_value());
  const Vec3 normal = turn.col(0);
  EXPECT_NEAR(std::abs(symmetry.mirror->normal.dot(normal)), 1, 1e-4);
  EXPECT_NEAR(symmetry.mirror->normal.dot(shift), symmetry.mirror->offset, 0.01);
  EXPECT_LT(symmetry.error, 0.003);
  EXPECT_THAT(symmetries_text({symmetry}), testing::HasSubstr("   1  mirrored in the plane "));
}

TEST(SymmetriesOf, TellsThatABentBodyIsLessExact) {
  const double straight = symmetry_of(body(0), rough_mirror()).error, bent = symmetry_of(body(0.8), rough_mirror()).error;
  EXPECT_GT(bent, 5 * straight);
  EXPECT_GT(bent, 0.01);
}

TEST(SymmetriesOf, TellsOfARepetitionHowFarItLiesFromTheSurface) {
  const Mesh ball = meshes::moved(meshes::sphere(5), turn, shift);
  Similarity third{1, Eigen::AngleAxisd(2 * M_PI / 3, Vec3::UnitZ()).toRotationMatrix(), {}};
  third.shift = shift - third.rotation * shift;
  const Symmetry exact = symmetry_of(ball, third);
  EXPECT_FALSE(exact.mirror.has_value());
  EXPECT_LT(exact.error, 0.001);
  EXPECT_THAT(symmetries_text({exact}), testing::HasSubstr("repeated, 1.000 times as large, turned by 120.0 degrees about (0, 0, 1)"));
  third.shift += Vec3(0.1, 0, 0);
  EXPECT_NEAR(symmetry_of(ball, third).error * bounding_box(ball).diagonal(), 0.1 / std::sqrt(3), 0.01) << "mean square of 0.1 cosine";
}

TEST(SymmetriesOf, AMirrorImageElsewhereHasNoPlane) {
  Similarity beside = rough_mirror();
  beside.shift += 20 * Vec3::UnitZ();
  const Symmetry symmetry = symmetry_of(body(0), beside);
  EXPECT_FALSE(symmetry.mirror.has_value());
  EXPECT_THAT(symmetries_text({symmetry}), testing::HasSubstr("repeated as its mirror image (x negated first), 0.970 times"));
}

TEST(SymmetriesJson, SaysTheSame) {
  const Symmetry mirror{Plane{{0, 1, 0}, 2}, {}, 0.25}, repeated{{}, {2, Mat3::Identity(), {1, 2, 3}}, 0.5};
  const nlohmann::json list = nlohmann::json::parse(symmetries_json({mirror, repeated}))["symmetries"];
  EXPECT_EQ(list[0], nlohmann::json::parse(R"({"kind": "mirrored", "normal": [0, 1, 0], "offset": 2, "error": 0.25})"));
  EXPECT_EQ(list[1]["kind"], "repeated");
  EXPECT_EQ(list[1]["mirrored"], false);
  EXPECT_EQ(list[1]["shift"], nlohmann::json::parse("[1, 2, 3]"));
}

TEST(SymmetriesText, SaysNoMoreThanItKnows) {
  const Symmetry mirror{Plane{{1, -1e-9, 0}, 2}, {}, 1e-9};
  EXPECT_EQ(symmetries_text({mirror}),
            "   1  mirrored in the plane 1.0000 x +0.0000 y +0.0000 z = 2; it lies within 0.001 % of the diagonal (root mean square)\n");
}

}  // namespace
}  // namespace homolog
