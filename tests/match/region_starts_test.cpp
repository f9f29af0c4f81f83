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
    const std::vector<GrownSet> starts =
        region_starts(regions_to_lay_on(data.body), part, chirality, distance_on_whole(part, data, chirality), 12);
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

// Of a part that is bent otherwise in the data no similarity lays all, but one lays what does not bend.
TEST(RegionStarts, OutwardOnesLayTheirRegionThoughTheRestIsBent) {
  const auto bent = [](const Vec3& x) {
    const Vec3 joint(0.35, 0, 0);
    const double angle = 1.2 * std::clamp((x.x() - 0.3) / 0.1, 0.0, 1.0);
    return Vec3(joint + Eigen::AngleAxisd(angle, Vec3::UnitZ()) * (x - joint));
  };
  const Shape part = foreparts();
  Mesh mesh = mesh_of(quadruped(), 64);
  for (Vec3& v : mesh.vertices) v = bent(v);
  const Shape data = describe_shape(mesh, coarse());
  const std::vector<GrownSet> starts =
      outward_starts(regions_to_lay_on(data.body), part, data, Chirality::proper, distance_on_whole(part, data, Chirality::proper), 12);
  double least = 1;
  for (const GrownSet& start : starts) {
    ASSERT_TRUE(start.drawn_from);
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < part.body.surface_count; ++i) {
      if (part.body.ways(i, *start.drawn_from) > 0.3 * part.diagonal) continue;
      sum += (start.spline(part.body.nodes[i]) - bent(part.body.nodes[i])).norm(), ++count;
    }
    least = std::min(least, sum / count / part.diagonal);
  }
  EXPECT_LT(least, 0.1);
}

TEST(RegionStarts, AreDifferent) {
  const Shape data = described(quadruped());
  const Shape part = foreparts();
  const double on_whole = distance_on_whole(part, data, Chirality::proper);
  const std::vector<GrownSet> starts = region_starts(regions_to_lay_on(data.body), part, Chirality::proper, on_whole, 12);
  for (std::size_t a = 0; a < starts.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) EXPECT_GT((starts[a].spline.affine - starts[b].spline.affine).norm(), 0.05);
  }
}

TEST(RegionStarts, WithoutSkinThereIsNone) {
  const Shape empty = bare_shape({});
  const double on_whole = distance_on_whole(empty, empty, Chirality::proper);
  EXPECT_TRUE(region_starts({}, empty, Chirality::proper, on_whole, 12).empty());
  EXPECT_TRUE(outward_starts({}, empty, empty, Chirality::proper, on_whole, 12).empty());
}

}  // namespace
}  // namespace homolog
