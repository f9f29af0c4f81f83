// SPDX-License-Identifier: MIT
// From many sources at once, against Dijkstra's ways from one after the other.
#include "homolog/describe/all_ways.h"

#include <gtest/gtest.h>

#include "fixtures/solids.h"
#include "homolog/base/parallel.h"

namespace homolog {
namespace {

using namespace fixtures;

// Two limbs that cross, and a ball apart from them.
Body body_of_two_pieces() {
  const Solid solid = join({capsule({-1, 0, 0}, {1, 0, 0}, 0.1), capsule({0, -1, 0}, {0, 1, 0.3}, 0.1), ball({1, 1, 1}, 0.2)});
  const Interior interior = rasterize(solid, 64);
  return build_body(interior, sample_surface(interior, 150), 150, {{{0, 0, 0}, 0.1}, {{1, 1, 1}, 0.1}});
}

TEST(AllWays, AreDijkstras) {
  const Body body = body_of_two_pieces();
  const Eigen::MatrixXd ways = all_ways(body);
  ASSERT_EQ(ways.cols(), static_cast<Eigen::Index>(body.nodes.size()));
  for (int source = 0; source < static_cast<int>(body.nodes.size()); ++source) {
    const std::vector<double> expected = shortest_ways(body, {source});
    for (std::size_t node = 0; node < expected.size(); ++node) EXPECT_EQ(ways(node, source), expected[node]);
  }
}

TEST(AllWays, DoNotDependOnThreads) {
  const Body body = body_of_two_pieces();
  const ThreadLimit one(1);
  EXPECT_EQ(all_ways(body), body.ways);
}

TEST(AllWays, OfNothingAreNone) { EXPECT_EQ(all_ways({}).size(), 0); }

}  // namespace
}  // namespace homolog
