// SPDX-License-Identifier: MIT
// Ends pair by the ways between them, at any scale.
#include "homolog/match/end_pairs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace homolog {
namespace {

// Ends at given places with straight ways.
Ends ends_at(const std::vector<Vec3>& places, double scale = 1) {
  Ends ends;
  const auto count = static_cast<Eigen::Index>(places.size());
  ends.ways.resize(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    ends.nodes.push_back(static_cast<int>(i));
    for (Eigen::Index j = 0; j < count; ++j) ends.ways(i, j) = scale * (places[i] - places[j]).norm();
  }
  return ends;
}

const std::vector<Vec3> places = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {3, 3, 1}};

TEST(EndPairs, TheSameEndsPairAtAnyScale) {
  for (const double scale : {1e-3, 1.0, 50.0}) {
    const std::vector<EndPairs> sets = pair_ends(ends_at(places), ends_at(places, scale), 60);
    ASSERT_FALSE(sets.empty());
    ASSERT_EQ(sets[0].pairs.size(), places.size());
    for (const auto& [a, b] : sets[0].pairs) EXPECT_EQ(a, b);
    EXPECT_NEAR(sets[0].log_scale, std::log(scale), 1e-9);
    EXPECT_NEAR(sets[0].score, 5, 1e-9);
  }
}

TEST(EndPairs, AnEndThatHasNoCounterpartStaysFree) {
  std::vector<Vec3> more = places;
  more.emplace_back(-9, 4, -7);
  const std::vector<EndPairs> sets = pair_ends(ends_at(more), ends_at(places), 60);
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets[0].pairs.size(), places.size());
  for (const auto& [a, b] : sets[0].pairs) EXPECT_EQ(a, b);
}

TEST(EndPairs, ComeBestFirstOneToOneAndOnce) {
  const std::vector<EndPairs> sets = pair_ends(ends_at(places), ends_at(places), 60);
  for (std::size_t s = 0; s < sets.size(); ++s) {
    if (s > 0) EXPECT_LE(sets[s].score, sets[s - 1].score);
    for (std::size_t t = 0; t < s; ++t) EXPECT_NE(sets[s].pairs, sets[t].pairs);
    std::vector<char> model_used(places.size()), data_used(places.size());
    for (const auto& [a, b] : sets[s].pairs) {
      EXPECT_FALSE(model_used[a]++);
      EXPECT_FALSE(data_used[b]++);
    }
  }
}

TEST(EndPairs, TwoEndsOrSeparatePiecesAreTooLittle) {
  EXPECT_TRUE(pair_ends(ends_at({places[0], places[1]}), ends_at(places), 60).empty());
  Ends apart = ends_at({places[0], places[1], places[2]});
  apart.ways(0, 2) = apart.ways(2, 0) = apart.ways(1, 2) = apart.ways(2, 1) = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(pair_ends(apart, ends_at(places), 60).empty());
}

}  // namespace
}  // namespace homolog
