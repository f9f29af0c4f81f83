// SPDX-License-Identifier: MIT
#include "homolog/salient/row_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace homolog {
namespace {

std::vector<float> uneven(int count, int seed) {
  std::vector<float> values(count);
  for (int i = 0; i < count; ++i) values[i] = std::sin(static_cast<float>(i * i + seed)) * std::exp2(static_cast<float>(i % 7));
  return values;
}

// Bit by bit the plain loop, for all numbers of blocks and unaligned rows; nothing beside [begin, end) is touched.
TEST(RowSums, WeighedRowsEqualThePlainLoop) {
  constexpr int length = 11 * row_block, radius = 5;
  const std::vector<float> weights = uneven(radius + 1, 3);
  std::vector<std::vector<float>> values;
  std::vector<const float*> rows;
  for (int t = 0; t <= 2 * radius; ++t) values.push_back(uneven(length + t, t));
  for (int t = 0; t <= 2 * radius; ++t) rows.push_back(values[t].data() + t % 3);
  for (int begin = 0; begin < length; begin += 2 * row_block) {
    for (int end = begin; end + 3 <= length; end += row_block) {
      std::vector<float> out(length, -7);
      weigh_rows(rows.data() + radius, weights.data(), radius, begin, end, out.data());
      for (int x = 0; x < length; ++x) {
        volatile float sum = -7;  // rounds after every step
        if (x >= begin && x < end) {
          sum = weights[0] * rows[radius][x];
          for (int t = 1; t <= radius; ++t) {
            volatile float product = rows[radius - t][x] + rows[radius + t][x];
            product = weights[t] * product;
            sum = sum + product;
          }
        }
        ASSERT_EQ(out[x], sum) << begin << " " << end << " " << x;
      }
    }
  }
}

TEST(RowSums, SubtractedRowsEqualThePlainLoop) {
  const std::vector<float> a = uneven(6 * row_block, 1), b = uneven(6 * row_block, 2);
  std::vector<float> row = a;
  subtract_row(b.data(), 1.7f, row_block, 4 * row_block, row.data());
  for (int x = 0; x < 6 * row_block; ++x) {
    volatile float difference = a[x] - b[x];
    const bool inside = x >= row_block && x < 4 * row_block;
    ASSERT_EQ(row[x], inside ? 1.7f * difference : a[x]) << x;
  }
}

}  // namespace
}  // namespace homolog
