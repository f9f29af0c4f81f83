// SPDX-License-Identifier: MIT
#include "homolog/salient/rolling_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace homolog {
namespace {

GridFrame grid(int nx, int ny, int nz) { return {{nx, ny, nz}, Vec3::Zero(), 1}; }

using Kinds = std::vector<std::uint8_t>;

TEST(BlockRows, ConstantBlocksAreWrittenInAllRowsOfASlot) {
  BlockRows rows(3, 2, 2, 0.9f);
  rows.begin(1, Kinds{empty_block, mixed_block, full_block}.data());
  for (int n = 0; n < 2; ++n) {
    EXPECT_EQ(std::count(rows.row(1, n), rows.row(1, n) + row_block, 0.0f), row_block);
    EXPECT_EQ(std::count(rows.row(1, n) + 2 * row_block, rows.row(1, n) + 3 * row_block, 0.9f), row_block);
  }
  rows.row(1)[5] = 0.5f;
  rows.begin(1, Kinds{mixed_block, mixed_block, mixed_block}.data());
  EXPECT_EQ(rows.row(1)[5], 0.5f);
  std::fill_n(rows.row(1) + row_block, row_block, 0.9f);
  rows.settle(1);
  EXPECT_EQ(Kinds(rows.kinds(1), rows.kinds(1) + 3), (Kinds{mixed_block, full_block, full_block}));
}

TEST(RollingVolume, NewSlicesTakeThePlaceOfOldOnesAndAreZeroBeyondTheFrame) {
  RollingVolume volume(grid(40, 2, 100), 3, 1);
  for (int k = 0; k < 10; ++k) {
    const Kinds kinds = k % 2 == 0 ? Kinds{mixed_block, full_block, mixed_block} : Kinds{empty_block, mixed_block, empty_block};
    float* row = volume.begin_row(1, k, kinds.data());
    for (int b = 0; b < 3; ++b) {
      if (kinds[b] == mixed_block) std::fill_n(row + b * row_block, row_block, static_cast<float>(k + 2));  // beyond the frame, too
    }
    volume.end_row(1, k);
  }
  for (int k = 7; k < 10; ++k) {
    const bool even = k % 2 == 0;
    const float* row = volume.row(1, k);
    for (int i = 0; i < 48; ++i) ASSERT_EQ(row[i], i / row_block == 1 ? (even ? 1 : k + 2) : even && i < 40 ? k + 2 : 0) << i << " " << k;
    EXPECT_EQ(volume.kinds(1, k)[0], even ? mixed_block : empty_block);
  }
}

TEST(RollingVolume, RowsStartOnCacheLines) {
  const RollingVolume volume(grid(33, 3, 4), 4, 1);
  EXPECT_EQ(volume.blocks(), 3);
  for (int j = 0; j < 3; ++j) EXPECT_EQ(reinterpret_cast<std::uintptr_t>(volume.row(j, 2)) % 64, 0u);
}

TEST(RollingVolume, ColumnsJoinKindsAndEndInZeros) {
  RollingVolume volume(grid(32, 1, 4), 4, 1);
  for (int k = 0; k < 4; ++k) volume.begin_row(0, k, (k < 2 ? Kinds{full_block, empty_block} : Kinds{full_block, full_block}).data());
  std::vector<const float*> rows(5);
  Kinds kinds(2);
  volume.column(0, -1, rows, kinds);
  EXPECT_EQ(kinds, (Kinds{mixed_block, mixed_block}));  // zeros beyond the frame, too
  EXPECT_EQ(std::count(rows[0], rows[0] + 32, 0.0f), 32);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(rows[k + 1], volume.row(0, k));
  rows.resize(2);
  volume.column(0, 0, rows, kinds);
  EXPECT_EQ(kinds, (Kinds{full_block, empty_block}));
  volume.column(7, 0, rows, kinds);
  EXPECT_EQ(kinds, (Kinds{empty_block, empty_block}));
}

}  // namespace
}  // namespace homolog
