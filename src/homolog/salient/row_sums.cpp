// SPDX-License-Identifier: MIT
#include "homolog/salient/row_sums.h"

#include "homolog/base/widest_clone.h"

namespace homolog {
namespace {

// `count` times sixteen from x on, their sums in registers.
template <int count>
[[gnu::always_inline]] inline void weigh_blocks(const float* const* rows, const float* weights, int radius, int x, float* out) {
  SixteenFloats sum[count];
  for (int i = 0; i < count; ++i) sum[i] = weights[0] * sixteen(rows[0] + x + i * row_block);
  for (int t = 1; t <= radius; ++t) {
    const float *before = rows[-t] + x, *after = rows[t] + x, weight = weights[t];
    for (int i = 0; i < count; ++i) sum[i] += weight * (sixteen(before + i * row_block) + sixteen(after + i * row_block));
  }
  for (int i = 0; i < count; ++i) sixteen(out + x + i * row_block) = sum[i];
}

}  // namespace

HOMOLOG_WIDEST_CLONE void weigh_rows(const float* const* rows, const float* weights, int radius, int begin, int end, float* out) {
  int x = begin;
  for (; x + 4 * row_block <= end; x += 4 * row_block) weigh_blocks<4>(rows, weights, radius, x, out);
  if (x + 2 * row_block <= end) {
    weigh_blocks<2>(rows, weights, radius, x, out);
    x += 2 * row_block;
  }
  if (x < end) weigh_blocks<1>(rows, weights, radius, x, out);
}

HOMOLOG_WIDEST_CLONE void subtract_row(const float* other, float factor, int begin, int end, float* row) {
  for (int x = begin; x < end; x += row_block) sixteen(row + x) = factor * (sixteen(row + x) - sixteen(other + x));
}

}  // namespace homolog
