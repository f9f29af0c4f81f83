// SPDX-License-Identifier: MIT
#include "homolog/describe/surface_samples.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fixtures/solids.h"

namespace homolog {
namespace {

using namespace fixtures;

const Vec3 centre(3, -1, 2);
constexpr double radius = 0.7;

TEST(SurfaceSamples, OfABallLieOnItAndFaceAwayFromItsCentre) {
  const Interior interior = rasterize(ball(centre, radius), 48);
  const auto samples = sample_surface(interior, 600);
  ASSERT_EQ(samples.size(), 600u);
  double worst = 1;
  for (const SurfaceSample& s : samples) {
    EXPECT_NEAR((s.position - centre).norm(), radius, 0.5 * interior.frame.spacing);
    EXPECT_NEAR(s.normal.norm(), 1, 1e-12);
    worst = std::min(worst, s.normal.dot((s.position - centre).normalized()));
  }
  EXPECT_GT(worst, 0.995);  // within 6 degrees
}

double distance_to(const Vec3& place, const std::vector<SurfaceSample>& samples, std::size_t count) {
  double least = INFINITY;
  for (std::size_t i = 0; i < count; ++i) least = std::min(least, (samples[i].position - place).norm());
  return least;
}

TEST(SurfaceSamples, EveryPrefixIsEven) {
  const Interior interior = rasterize(hand(), 64);
  const auto samples = sample_surface(interior, 1000);
  for (const std::size_t prefix : {20, 100, 400}) {
    double gap = 0, spacing = INFINITY;
    for (const SurfaceSample& s : samples) gap = std::max(gap, distance_to(s.position, samples, prefix));
    for (std::size_t i = 1; i < prefix; ++i) spacing = std::min(spacing, distance_to(samples[i].position, samples, i));
    EXPECT_LT(gap, spacing + 2 * interior.frame.spacing) << prefix;  // farthest-point order, but for settling by a voxel at either end
  }
}

TEST(SurfaceSamples, APrefixIsWhatFewerSamplesWouldBe) {
  const Interior interior = rasterize(quadruped(), 48);
  const auto all = sample_surface(interior, 500), few = sample_surface(interior, 50);
  for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(few[i].position, all[i].position);
}

TEST(SurfaceSamples, TheirDiagonalIsThatOfTheirBoxHoweverTheyAreTurned) {
  const auto samples = sample_surface(rasterize(box({1, 2, 3}, {0.3, 0.6, 0.2}), 48), 2000);
  const double diagonal = diagonal_of(samples);
  EXPECT_NEAR(diagonal / (2 * Vec3(0.3, 0.6, 0.2).norm()), 1, 0.05);
  for (const int seed : {1, 2, 3}) {
    const Similarity move{random_rotation(seed), 20, {100, 0, -7}};
    auto turned = samples;
    for (SurfaceSample& s : turned) s.position = move(s.position);
    EXPECT_NEAR(diagonal_of(turned) / (20 * diagonal), 1, 1e-12);
  }
  EXPECT_EQ(diagonal_of({}), 0);
}

TEST(SurfaceSamples, ASmallSolidGivesFewerThanAskedForAndAnEmptyOneNone) {
  const GridFrame frame{{8, 8, 8}, Vec3::Constant(-3.5), 1};
  const auto samples = sample_surface(rasterize(ball(Vec3::Zero(), 2), frame), 1000);
  EXPECT_GT(samples.size(), 10u);
  EXPECT_LT(samples.size(), 60u);  // no more than voxels; each at most once
  EXPECT_TRUE(sample_surface(Interior{frame, std::vector<float>(frame.voxels(), 0)}, 10).empty());
}

TEST(SurfaceSamples, AFullGridEndsAtItsBorder) {
  const GridFrame frame{{6, 6, 6}, Vec3::Zero(), 1};
  for (const SurfaceSample& s : sample_surface(Interior{frame, std::vector<float>(frame.voxels(), 1)}, 100)) {
    const Vec3 middle = s.position - Vec3::Constant(2.5);
    EXPECT_NEAR(middle.cwiseAbs().maxCoeff(), 3, 0.5);
    EXPECT_GT(s.normal.dot(middle), 0);
  }
}

}  // namespace
}  // namespace homolog
