// SPDX-License-Identifier: MIT
#include "homolog/shape/weld.h"

#include <gtest/gtest.h>

#include <random>

namespace homolog {
namespace {

TEST(Weld, JoinsEqualPositionsInOrderOfFirstOccurrence) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, -0.0}}, {{0, 1, 2}, {3, 4, 5}, {1, 3, 4}}};
  const Mesh welded = weld(mesh);
  EXPECT_EQ(welded.vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(welded.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {1, 3, 2}}));
}

TEST(Welder, FindsEveryVertexAgainHoweverLargeItsTableHasGrown) {
  Welder welder;
  const auto place = [](std::uint32_t i) { return Vec3(i % 17, i / 17 % 19, i / 323); };
  for (int pass = 0; pass < 2; ++pass) {
    for (std::uint32_t i = 0; i < 5000; ++i) ASSERT_EQ(welder.vertex_at(place(i)), i);
  }
  EXPECT_EQ(welder.mesh.vertices.size(), 5000u);
}

TEST(Weld, KeepsVerticesThatAreOnlyNear) {
  EXPECT_EQ(first_equal_vertex({{0, 0, 0}, {1e-300, 0, 0}, {0, 0, 0}}), (std::vector<std::uint32_t>{0, 1, 0}));
}

TEST(Weld, TheNearestLeaderIsThatOfAllPairs) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Vec3> places;
  for (int i = 0; i < 2000; ++i) places.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  std::vector<std::uint8_t> loose(places.size());
  for (std::size_t i = 0; i < loose.size(); ++i) loose[i] = i % 5 != 0;
  const double distance = 0.1;
  const std::vector<std::uint32_t> leader = nearest_leader(places, loose, distance);
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    std::uint32_t expected = i;
    double nearest = distance;
    for (std::uint32_t j = 0; j < i && loose[i]; ++j) {
      if (!loose[j] || leader[j] != j || (places[i] - places[j]).norm() >= nearest) continue;
      expected = j;
      nearest = (places[i] - places[j]).norm();
    }
    EXPECT_EQ(leader[i], expected);
  }
}

}  // namespace
}  // namespace homolog
