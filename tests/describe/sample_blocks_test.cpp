// SPDX-License-Identifier: MIT
// Blocks hold every sample once and find the nearest one as looking at all of them does.
#include "homolog/describe/sample_blocks.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>

namespace homolog {
namespace {

std::vector<Vec3> scattered(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1, 1);
  std::vector<Vec3> places;
  for (int i = 0; i < count; ++i) places.emplace_back(100 + place(random), place(random), 0.1 * place(random));
  return places;
}

std::vector<SurfaceSample> samples_at(const std::vector<Vec3>& places) {
  std::vector<SurfaceSample> samples;
  for (const Vec3& place : places) samples.push_back({place, Vec3::UnitZ()});
  return samples;
}

TEST(SampleBlocks, HoldEverySampleOnce) {
  for (const int count : {1, 15, 16, 17, 100, 401}) {
    const std::vector<Vec3> places = scattered(count, 1);
    const SampleBlocks samples = make_blocks(samples_at(places));
    EXPECT_EQ(static_cast<int>(samples.blocks.size()), (count + block_size - 1) / block_size);
    std::set<int> seen;
    for (const SampleBlock& block : samples.blocks) {
      for (const int sample : block.sample) {
        if (sample >= 0) EXPECT_TRUE(seen.insert(sample).second);
      }
    }
    EXPECT_EQ(static_cast<int>(seen.size()), count);
  }
}

TEST(SampleBlocks, FindTheNearest) {
  const std::vector<Vec3> places = scattered(300, 2);
  const SampleBlocks samples = make_blocks(samples_at(places));
  for (const Vec3& place : scattered(200, 3)) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& other : places) least = std::min(least, (other - place).norm());
    const NearestSample found = nearest_sample(samples, place);
    EXPECT_NEAR(found.distance, least, 1e-6);
    EXPECT_NEAR((places[found.sample] - place).norm(), least, 1e-6);
  }
}

TEST(SampleBlocks, NoSamplesNoNearest) { EXPECT_EQ(nearest_sample(make_blocks({}), Vec3::Zero()).sample, -1); }

}  // namespace
}  // namespace homolog
