// SPDX-License-Identifier: MIT
#include "homolog/salient/rolling_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace homolog {
namespace {

GridFrame grid(int nx, int ny, int nz) { return {{nx, ny, nz}, Vec3::Zero(), 1}; }

TEST(RollingVolume, NewSlicesTakeThePlaceOfOldOnesAndAreZeroOutsideTheirRun) {
  RollingVolume volume(grid(40, 2, 100), 3);
  for (int k = 0; k < 10; ++k) {
    const homolog::Run run = k % 2 == 0 ? homolog::Run{k, 40} : homolog::Run{20, 21};
    float* row = volume.begin_row(1, k, run);
    std::fill(row + run.low, row + run.high, static_cast<float>(k + 1));
  }
  for (int k = 7; k < 10; ++k) {
    const homolog::Run run = volume.run(1, k);
    for (int i = 0; i < 40; ++i) ASSERT_EQ(volume.row(1, k)[i], i >= run.low && i < run.high ? k + 1 : 0) << i << " " << k;
    EXPECT_EQ(volume.row(0, k)[5], 0);
  }
}

TEST(RollingVolume, RowsStartOnCacheLines) {
  const RollingVolume volume(grid(33, 3, 4), 4);
  EXPECT_EQ(volume.stride(), 48);
  for (int j = 0; j < 3; ++j) EXPECT_EQ(reinterpret_cast<std::uintptr_t>(volume.row(j, 2)) % 64, 0u);
}

TEST(RollingVolume, ColumnsJoinRunsAndEndInZeros) {
  RollingVolume volume(grid(16, 1, 4), 4);
  for (int k = 0; k < 4; ++k) *volume.begin_row(0, k, {2 * k, 2 * k + 1}) = 0;
  std::vector<const float*> rows(5);
  const homolog::Run run = volume.column(0, 1, rows);
  EXPECT_EQ(run.low, 0);
  EXPECT_EQ(run.high, 7);
  EXPECT_EQ(std::count(rows[0], rows[0] + 16, 0.0f), 16);
  for (int t = -1; t <= 2; ++t) EXPECT_EQ(rows[t + 2], volume.row(0, 1 + t));
}

}  // namespace
}  // namespace homolog
