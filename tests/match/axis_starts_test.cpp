// SPDX-License-Identifier: MIT
#include "homolog/match/axis_starts.h"

#include <gtest/gtest.h>

#include "fixtures/laid.h"

namespace homolog {
namespace {

using namespace fixtures;
using Move = fixtures::Similarity;

TEST(AxisStarts, TheBestOneLaysAShapeOnItsCopy) {
  const Shape model = described(hand());
  for (const Mat3& rotation : {random_rotation(8), Mat3(random_rotation(9) * mirror_x())}) {
    const Move move{rotation, 20, {50, -30, 7}};
    const Shape data = described(moved(hand(), move));
    const Chirality chirality = rotation.determinant() > 0 ? Chirality::proper : Chirality::mirrored;
    const std::vector<GrownSet> starts = axis_starts(model, data, chirality, 4);
    ASSERT_FALSE(starts.empty());
    EXPECT_LE(starts.size(), 4u);
    EXPECT_LT(mean_error(starts[0], model, move) / data.diagonal, 0.02);  // samples differ; a quarter of their spacing
    EXPECT_NEAR(starts[0].spline.similarity.scale / 20, 1, 0.03);
    for (const GrownSet& start : starts) {
      EXPECT_EQ(start.chirality, chirality);
      EXPECT_NEAR(start.spline.similarity.rotation.determinant(), chirality == Chirality::proper ? 1 : -1, 1e-9);
      EXPECT_TRUE(start.pairs.empty());
    }
  }
}

TEST(AxisStarts, AreDifferent) {
  const Shape shape = described(quadruped(), 48);
  const std::vector<GrownSet> starts = axis_starts(shape, shape, Chirality::proper, 4);
  for (std::size_t a = 0; a < starts.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const homolog::Similarity& s = starts[b].spline.similarity;
      EXPECT_GT(mean_error(starts[a], shape, {s.rotation, s.scale, s.shift}) / shape.diagonal, 0.1);
    }
  }
}

// A hand in its own place, and a smaller one turned beside it, no piece joined to the other.
TEST(AxisStarts, ReachEverySeparatePieceOfTheData) {
  const Shape model = described(hand());
  const Move here{Mat3::Identity(), 1, Vec3::Zero()}, there{random_rotation(4), 0.6, {2 * model.diagonal, 0, 0}};
  const Shape data = described(join({hand(), moved(hand(), there)}), 96);
  const std::vector<GrownSet> starts = axis_starts(model, data, Chirality::proper, 4);
  for (const Move& truth : {here, there}) {
    double least = 1;
    for (const GrownSet& start : starts) least = std::min(least, mean_error(start, model, truth) / (truth.scale * model.diagonal));
    EXPECT_LT(least, 0.05);  // nearer than two maps that count as one (family.cpp)
  }
}

TEST(AxisStarts, WithoutSkinThereIsNone) {
  const Shape empty = bare_shape({});
  EXPECT_TRUE(axis_starts(empty, empty, Chirality::proper, 4).empty());
}

}  // namespace
}  // namespace homolog
