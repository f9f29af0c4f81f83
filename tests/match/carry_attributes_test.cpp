// SPDX-License-Identifier: MIT
#include "homolog/match/carry_attributes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "match/bent_ball.h"

namespace homolog {
namespace {

using namespace bent_ball;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A colour and a value that tell the place on the ball, and a label that tells its octant, two million apart.
double octant(const Vec3& x) { return 2e6 * ((x.x() > 0) + 2 * (x.y() > 0) + 4 * (x.z() > 0)) + 1; }

AttributedMesh painted_ball() {
  AttributedMesh mesh{ball, {}, {{"height", Field::Kind::value, {}}, {"octant", Field::Kind::label, {}}}};
  for (const Vec3& x : ball.vertices) {
    const Vec3 share = (x + Vec3::Ones()) / 2;
    mesh.colours.push_back({static_cast<float>(share.x()), static_cast<float>(share.y()), static_cast<float>(share.z()), 1});
    mesh.fields[0].values.push_back(x.z());
    mesh.fields[1].values.push_back(octant(x));
  }
  return mesh;
}

TEST(CarryAttributes, BringsColoursAndValuesOfABallWhereItIsBentTo) {
  const AttributedMesh giver = painted_ball();
  const DenseMap map = dense_maps(match_by(bend), ball, bent).model_from_data;
  const AttributedMesh carried = carry_attributes(giver, bent, map.places);
  const Mesh at_rest = meshes::moved(meshes::sphere(4), fixtures::random_rotation(3));  // which was bent
  ASSERT_EQ(carried.colours.size(), bent.vertices.size());
  double mean = 0;
  for (std::size_t i = 0; i < bent.vertices.size(); ++i) {
    const Vec3 place = 2 * Vec3(carried.colours[i][0], carried.colours[i][1], carried.colours[i][2]) - Vec3::Ones();
    EXPECT_LT((place - at_rest.vertices[i]).norm(), 0.15);  // of a ball of radius 1
    EXPECT_NEAR(carried.fields[0].values[i], place.z(), 1e-6);
    mean += (place - at_rest.vertices[i]).norm() / static_cast<double>(bent.vertices.size());
  }
  EXPECT_LT(mean, 0.05);
}

TEST(CarryAttributes, NeverMakesALabelThatWasNotThere) {
  const AttributedMesh giver = painted_ball();
  const DenseMap map = dense_maps(match_by(bend), ball, bent).model_from_data;
  const AttributedMesh carried = carry_attributes(giver, bent, map.places);
  const std::set<double> known(giver.fields[1].values.begin(), giver.fields[1].values.end());
  const Mesh at_rest = meshes::moved(meshes::sphere(4), fixtures::random_rotation(3));
  double right = 0;
  for (std::size_t i = 0; i < bent.vertices.size(); ++i) {
    EXPECT_EQ(known.count(carried.fields[1].values[i]), 1u);
    right += carried.fields[1].values[i] == octant(at_rest.vertices[i]);
  }
  EXPECT_GT(right / static_cast<double>(bent.vertices.size()), 0.9);
}

TEST(CarryAttributes, LeavesVerticesWithoutAPlaceWithoutValues) {
  std::vector<DensePlace> places(bent.vertices.size());
  places[0] = {7, Vec3(0, 1, 0), Vec3::Zero(), 1};
  const AttributedMesh giver = painted_ball(), carried = carry_attributes(giver, bent, places);
  const std::uint32_t corner = ball.triangles[7][1];
  EXPECT_EQ(carried.colours[0], giver.colours[corner]);
  EXPECT_EQ(carried.fields[1].values[0], giver.fields[1].values[corner]);
  EXPECT_EQ(carried.colours[1], no_colour);
  EXPECT_TRUE(std::isnan(carried.fields[0].values[1]));
  EXPECT_TRUE(std::isnan(carried.fields[1].values[1]));
}

TEST(CarryAttributes, NamesANumberForNoLabelThatIsNone) {
  AttributedMesh giver{ball, {}, {{"part", Field::Kind::label, std::vector<double>(ball.vertices.size(), -1)}}};
  giver.fields[0].values[5] = none;
  EXPECT_EQ(carry_attributes(giver, bent, std::vector<DensePlace>(bent.vertices.size())).fields[0].no_label, -2);
  giver.fields[0].values.assign(ball.vertices.size(), 4);
  EXPECT_EQ(carry_attributes(giver, bent, std::vector<DensePlace>(bent.vertices.size())).fields[0].no_label, -1);
}

TEST(ValueBetween, SharesOutAndLeavesUnknownCornersOut) {
  EXPECT_DOUBLE_EQ(value_between({1, 2, 6}, {0.5, 0.25, 0.25}), 2.5);
  EXPECT_DOUBLE_EQ(value_between({1, none, 6}, {0.5, 0.25, 0.25}), 2 / 0.75);
  EXPECT_TRUE(std::isnan(value_between({1, none, none}, {0.4, 0.3, 0.3})));
}

TEST(LabelBetween, TakesTheLargestShare) {
  EXPECT_EQ(label_between({1, 9, 9}, {0.4, 0.3, 0.3}), 9);
  EXPECT_EQ(label_between({1, 5, 9}, {0.4, 0.3, 0.3}), 1);
  EXPECT_EQ(label_between({1, 9, 5}, {0.5, 0.5, 0}), 1) << "the first of equal ones";
  EXPECT_TRUE(std::isnan(label_between({1, none, none}, {0.4, 0.3, 0.3})));
}

}  // namespace
}  // namespace homolog
