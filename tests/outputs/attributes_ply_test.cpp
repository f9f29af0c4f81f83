// SPDX-License-Identifier: MIT
#include "homolog/outputs/attributes_ply.h"

#include <gmock/gmock.h>

#include <cmath>

#include "homolog/shape/read_ply_attributes.h"

namespace homolog {
namespace {

using testing::HasSubstr;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
const Mesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
const std::vector<DensePlace> places{{0, Vec3(1, 0, 0), Vec3::Zero(), 1}, {0, Vec3(0, 1, 0), Vec3::UnitX(), 1}, {}};

TEST(AttributesPly, IsReadAsItWasWritten) {
  const AttributedMesh mesh{triangle,
                            {{1, 0.2f, 0, 1}, {0, 0, 1, 0.4f}, no_colour},
                            {{"depth", Field::Kind::value, {0.1, 1e-300, none}}, {"part", Field::Kind::label, {16777217, -5, none}, -6}}};
  const std::string text = attributes_ply(mesh, places, "bear\n.ply");
  EXPECT_THAT(text, HasSubstr("comment carried from bear .ply; where 'carried' is 0 values are nan, 'part' -6\n"));
  EXPECT_THAT(text, HasSubstr("property uchar alpha\nproperty double depth\nproperty int part\nproperty uchar carried\n"));
  EXPECT_THAT(text, HasSubstr("\n0 1 0 128 128 128 255 nan -6 0\n"));
  const AttributedMesh again = read_ply_attributes(text, "a.ply");
  EXPECT_EQ(again.mesh.vertices, triangle.vertices);
  EXPECT_EQ(again.colours, mesh.colours);
  ASSERT_EQ(again.fields.size(), 3u);
  EXPECT_EQ(again.fields[0].values[1], 1e-300);
  EXPECT_EQ(again.fields[1].values, (std::vector<double>{16777217, -5, -6}));
  EXPECT_EQ(again.fields[2].values, (std::vector<double>{1, 1, 0}));
}

TEST(AttributesPly, SaysOnceWhatWasCarried) {
  const AttributedMesh mesh{triangle, {}, {{"carried", Field::Kind::label, {1, 1, 1}}, {"big", Field::Kind::label, {4e9, 1, none}}}};
  const std::string text = attributes_ply(mesh, places, "a.ply");
  EXPECT_THAT(text, HasSubstr("property double z\nproperty double big\nproperty uchar carried\nelement face"));
}

}  // namespace
}  // namespace homolog
