// SPDX-License-Identifier: MIT
#include "homolog/salient/row_sums.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace homolog {
namespace {

std::vector<float> uneven(int count, int seed) {
  std::vector<float> values(count);
  for (int i = 0; i < count; ++i) values[i] = std::sin(static_cast<float>(i * i + seed)) * std::exp2(static_cast<float>(i % 7));
  return values;
}

// The sums as they are promised, one fused multiply-add after the other.
float plain_sum(const std::vector<float>& half, const std::vector<float>& values) {
  const int radius = static_cast<int>(half.size()) - 1;
  float sum = 0;
  for (int t = -radius; t <= radius; ++t) sum = std::fma(half[std::abs(t)], values[t + radius], sum);
  return sum;
}

constexpr int length = 11 * row_block, radius = 5;

// Bit by bit, for all numbers of blocks; nothing beside [begin, end) is touched.
TEST(RowSums, SumsAcrossRowsEqualThePlainLoop) {
  const std::vector<float> half = uneven(radius + 1, 3);
  const RowWeights weights(half);
  std::vector<std::vector<float>> values, out;
  std::vector<const float*> rows;
  for (int t = 0; t < 2 * radius + row_group; ++t) values.push_back(uneven(length, t));
  for (const auto& row : values) rows.push_back(row.data());
  for (int begin = 0; begin < length; begin += 2 * row_block) {
    for (int end = begin; end <= length; end += row_block) {
      out.assign(row_group, std::vector<float>(length, -7));
      float* sums[row_group];
      for (int n = 0; n < row_group; ++n) sums[n] = out[n].data();
      weigh_across(rows.data(), weights, begin, end, sums);
      for (int n = 0; n < row_group; ++n) {
        for (int x = 0; x < length; ++x) {
          std::vector<float> column;
          for (int t = 0; t <= 2 * radius; ++t) column.push_back(rows[n + t][x]);
          ASSERT_EQ(out[n][x], x >= begin && x < end ? plain_sum(half, column) : -7) << begin << " " << end << " " << x;
        }
      }
    }
  }
}

TEST(RowSums, SumsAlongARowEqualThePlainLoop) {
  const std::vector<float> half = uneven(radius + 1, 4), values = uneven(length + 2 * radius, 8);
  const RowWeights weights(half);
  for (int begin = 0; begin < length; begin += 2 * row_block) {
    for (int end = begin; end <= length; end += row_block) {
      std::vector<float> out(length, -7);
      weigh_along(values.data() + radius, weights, 1e9f, begin, end, out.data());
      for (int x = 0; x < length; ++x) {
        const std::vector<float> around(values.begin() + x, values.begin() + x + 2 * radius + 1);
        const float sum = plain_sum(half, around);
        ASSERT_EQ(out[x], x < begin || x >= end ? -7 : sum < nearly_zero ? 0 : sum) << begin << " " << end << " " << x;
      }
    }
  }
}

TEST(RowSums, WhatIsNearlyConstantIsConstant) {
  constexpr float plateau = 0.75f;
  std::vector<float> row(row_block, 0.5f), out(row_block);
  row[1] = 0.5f * nearly_zero, row[2] = 2 * nearly_zero, row[3] = plateau - 0.5f * nearly_plateau, row[4] = plateau - 2 * nearly_plateau;
  weigh_along(row.data(), RowWeights({1}), plateau, 0, row_block, out.data());
  row[1] = 0, row[3] = plateau;
  EXPECT_EQ(out, row);
}

TEST(RowSums, KindsOfBlocks) {
  std::vector<float> block(row_block, 0.0f);
  EXPECT_EQ(kind_of(block.data(), 0.9f), empty_block);
  block[15] = 0.9f;
  EXPECT_EQ(kind_of(block.data(), 0.9f), mixed_block);
  block.assign(row_block, 0.9f);
  EXPECT_EQ(kind_of(block.data(), 0.9f), full_block);
  EXPECT_EQ(kind_of(block.data(), 1), mixed_block);
}

TEST(RowSums, LargestDifferenceIsFoundWhereverItIs) {
  const std::vector<float> b = uneven(4 * row_block, 2);
  for (int x = row_block; x < 3 * row_block; ++x) {
    std::vector<float> a = b;
    a[0] = a[3 * row_block] = 1000;  // not asked for
    a[x] += 2;
    EXPECT_EQ(largest_difference(a.data(), b.data(), 1.5f, row_block, 3 * row_block), 1.5f * (a[x] - b[x])) << x;
  }
}

}  // namespace
}  // namespace homolog
