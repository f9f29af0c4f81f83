// SPDX-License-Identifier: MIT
// Vectors of 16 floats, which the compiler splits into what the processor at hand has: 16, 8 or 4 at once, chosen at run time. There must
// be no fused multiply-add, whose rounding differs: CMakeLists.txt forbids it to the compiler. Under ThreadSanitizer there is no choice: it
// is made before that sanitizer has started, and crashes.
#include "homolog/salient/row_sums.h"

#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define HOMOLOG_WIDEST_CLONE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define HOMOLOG_WIDEST_CLONE
#endif

namespace homolog {
namespace {

// In memory; rows need not be aligned.
using Block [[gnu::vector_size(64), gnu::aligned(4), gnu::may_alias]] = float;

[[gnu::always_inline]] inline const Block& block(const float* p) { return *reinterpret_cast<const Block*>(p); }
[[gnu::always_inline]] inline Block& block(float* p) { return *reinterpret_cast<Block*>(p); }

// `count` blocks from x on, their sums in registers.
template <int count>
[[gnu::always_inline]] inline void weigh_blocks(const float* const* rows, const float* weights, int radius, int x, float* out) {
  Block sum[count];
  for (int i = 0; i < count; ++i) sum[i] = weights[0] * block(rows[0] + x + i * row_block);
  for (int t = 1; t <= radius; ++t) {
    const float *before = rows[-t] + x, *after = rows[t] + x, weight = weights[t];
    for (int i = 0; i < count; ++i) sum[i] += weight * (block(before + i * row_block) + block(after + i * row_block));
  }
  for (int i = 0; i < count; ++i) block(out + x + i * row_block) = sum[i];
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
  for (int x = begin; x < end; x += row_block) block(row + x) = factor * (block(row + x) - block(other + x));
}

}  // namespace homolog
