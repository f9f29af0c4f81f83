// SPDX-License-Identifier: MIT
#include "homolog/match/region_starts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fixtures/laid.h"

namespace homolog {
namespace {

using namespace fixtures;
using Move = fixtures::Similarity;

// The foreparts of an animal, cut off behind the shoulders.
Shape foreparts() {
  const Box front{{0.5, 0, 0}, {1, 1, 1}};
  return describe_shape(mesh_of(quadruped(), 64), coarse(), front);
}

TEST(RegionStarts, OneOfThemLaysAPartOnTheWholeFromAnyTurnAndSize) {
  const Shape part = foreparts();
  for (const Mat3& rotation : {random_rotation(8), Mat3(random_rotation(9) * mirror_x())}) {
    const Move move{rotation, 7, {5, -3, 70}};
    const Shape data = described(moved(quadruped(), move));
    const Chirality chirality = rotation.determinant() > 0 ? Chirality::proper : Chirality::mirrored;
    const std::vector<GrownSet> starts = region_starts(regions_of(data.body), part, data, chirality, 12);
    ASSERT_FALSE(starts.empty());
    EXPECT_LE(starts.size(), 12u);
    double least = 1;
    for (const GrownSet& start : starts) {
      EXPECT_EQ(start.chirality, chirality);
      EXPECT_TRUE(start.pairs.empty());
      least = std::min(least, mean_error(start, part, move) / (move.scale * part.diagonal));
    }
    EXPECT_LT(least, 0.1);  // near enough for the cloth, which reaches .06 and .15 beyond
  }
}

TEST(RegionStarts, AreDifferent) {
  const Shape data = described(quadruped());
  const std::vector<GrownSet> starts = region_starts(regions_of(data.body), foreparts(), data, Chirality::proper, 12);
  for (std::size_t a = 0; a < starts.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) EXPECT_GT((starts[a].spline.affine - starts[b].spline.affine).norm(), 0.05);
  }
}

TEST(RegionStarts, WithoutSkinThereIsNone) {
  const Shape empty = bare_shape({});
  EXPECT_TRUE(region_starts({}, empty, empty, Chirality::proper, 12).empty());
}

}  // namespace
}  // namespace homolog
