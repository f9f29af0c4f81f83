// SPDX-License-Identifier: MIT
#include "homolog/match/local_similarity.h"

#include <gtest/gtest.h>

#include <numeric>

#include "fixtures/solids.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

TEST(BestSimilarity, FindsTheOneThatThePairsWereMadeBy) {
  const Mat3 turn = fixtures::random_rotation(5);
  for (const Chirality chirality : {Chirality::proper, Chirality::mirrored}) {
    const Mat3 wanted = chirality == Chirality::proper ? turn : Mat3(turn * fixtures::mirror_x());
    std::vector<WeighedPair> pairs;
    for (const Vec3& x : meshes::sphere(1).vertices) pairs.push_back({x, 2.5 * (wanted * x) + Vec3(1, 2, 3), 1 + x.x() * x.x()});
    pairs.push_back({{9, 9, 9}, {0, 0, 0}, 0});  // which does not count
    const Similarity s = best_similarity(pairs, chirality);
    EXPECT_TRUE(s.rotation.isApprox(wanted, 1e-9));
    EXPECT_NEAR(s.scale, 2.5, 1e-9);
    EXPECT_TRUE(s.shift.isApprox(Vec3(1, 2, 3), 1e-9));
  }
}

TEST(BestSimilarity, MovesWhatLiesInOnePlace) {
  const Similarity s = best_similarity({{{1, 0, 0}, {4, 4, 4}, 1}, {{1, 0, 0}, {4, 4, 4}, 2}}, Chirality::proper);
  EXPECT_TRUE(s({1, 0, 0}).isApprox(Vec3(4, 4, 4)));
  EXPECT_EQ(s.scale, 1);
  EXPECT_TRUE(best_similarity({}, Chirality::proper)({1, 2, 3}).isApprox(Vec3(1, 2, 3)));
}

TEST(VertexAreas, AddUpToTheSurface) {
  const std::vector<double> areas = vertex_areas(meshes::box({0, 0, 0}, {1, 2, 3}));
  EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 22, 1e-12);
}

}  // namespace
}  // namespace homolog
