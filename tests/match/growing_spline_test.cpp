// SPDX-License-Identifier: MIT
// Sec. 6.1: the spline that grows pair by pair is the one that is solved at once (thin_plate_spline.h).
#include "homolog/match/growing_spline.h"

#include <gtest/gtest.h>

#include "match/synthetic_pairs.h"

namespace homolog {
namespace {

using synthetic::points_in_cube;

constexpr int asked = 40, sources = 25;

struct Sample {
  std::vector<Vec3> places = points_in_cube(asked, 1), targets = points_in_cube(sources, 2);
  std::vector<double> nugget;

  explicit Sample(double scale) {
    for (int i = 0; i < sources; ++i) nugget.push_back(0.02 * (1 + i % 3));
    for (Vec3& target : targets) target *= scale;
  }
};

TEST(Sec61, TheSplineThatGrowsIsTheOneSolvedAtOnceAfterEveryPair) {
  for (const auto chirality : {Chirality::proper, Chirality::mirrored}) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
      const Sample s(scale);
      GrowingSpline growing(s.places, chirality);
      std::vector<Vec3> X, Y;
      std::vector<double> nugget;
      for (int i = 0; i < sources; ++i) {
        growing.add(i, s.targets[i], s.nugget[i]);
        X.push_back(s.places[i]), Y.push_back(s.targets[i]), nugget.push_back(s.nugget[i]);
        if (i < 3) continue;
        const SourceSystem system(X, nugget);
        const auto solved = ThinPlateSpline::similarity_free(system, Y, chirality);
        const Similarity free = growing.free_part();
        ASSERT_NEAR(free.scale, solved.similarity.scale, 1e-9 * scale);
        ASSERT_TRUE(free.rotation.isApprox(solved.similarity.rotation, 1e-7));
        for (int place = 0; place < asked; ++place) {
          ASSERT_NEAR((growing.at(place, free) - solved(s.places[place])).norm(), 0, 1e-9 * scale);
          ASSERT_NEAR(growing.variance(place), system.variance(s.places[place]), 1e-9);
        }
      }
    }
  }
}

TEST(GrowingSpline, APlaceToldTwiceIsKnownBetterByWhatItsNuggetsLeave) {
  const auto targets = points_in_cube(6, 3);
  GrowingSpline growing(points_in_cube(asked, 1), Chirality::proper);
  for (int i = 0; i < 6; ++i) growing.add(i, targets[i], 0.1);
  const double once = growing.variance(2);
  growing.add(2, targets[2], 0.1);
  EXPECT_NEAR(growing.variance(2), 1 / (1 / once + 1 / 0.1), 1e-12);
}

}  // namespace
}  // namespace homolog
