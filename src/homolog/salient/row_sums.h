// SPDX-License-Identifier: MIT
// The inner loops of the scale space, on rows of floats in whole blocks. Every sum is made in one fixed order by fused multiply-adds, so
// that all widths of the processor's registers give the same bytes; a processor without them takes many times longer.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

namespace homolog {

/// Rows are worked on in blocks of so many floats; `begin` and `end` below are multiples of it.
inline constexpr int row_block = 16;
/// So many neighbouring sums are made at once, so that every row that is read serves many of them.
inline constexpr int row_group = 8;

/// What a block may hold. Joined by |: zeros and the plateau beside each other are mixed.
enum BlockKind : std::uint8_t {
  unset_block = 0,
  empty_block = 1,  ///< zeros
  full_block = 2,   ///< the plateau: what is far inside the shape
  mixed_block = 3,  ///< anything
};

/// A symmetric kernel for the sums below, made of its half: weights[t] for offsets t and -t.
class RowWeights {
 public:
  explicit RowWeights(const std::vector<float>& half);
  int radius() const { return radius_; }
  /// values()[t] is the weight of offset t - radius; just beyond both ends there are zeros, for sums that are made together.
  const float* values() const { return padded_.data() + row_group; }

 private:
  int radius_;
  std::vector<float> padded_;
};

/// sums[n][x] = sum over t = 0..2 radius of values[t] rows[n + t][x], for 0 <= n < row_group and begin <= x < end.
void weigh_across(const float* const* rows, const RowWeights& weights, int begin, int end, float* const* sums);

/// What differs less from 0 or from the plateau is taken for it: far less than sums about 1 are rounded, or as much.
inline constexpr float nearly_zero = 0x1p-30f, nearly_plateau = 0x1p-23f;

/// sums[x] = sum over t = 0..2 radius of values[t] row[x + t - radius], for begin <= x < end; 0 or the plateau where it is nearly that.
void weigh_along(const float* row, const RowWeights& weights, float plateau, int begin, int end, float* sums);

/// What a block holds: empty_block, full_block or mixed_block.
inline BlockKind kind_of(const float* block, float plateau) {
  const float value = block[0];
  if (value != 0 && value != plateau) return mixed_block;  // as are most
  if (std::memcmp(block, block + 1, (row_block - 1) * sizeof(float)) != 0) return mixed_block;
  return value == 0 ? empty_block : full_block;
}

/// The largest factor (a[x] - b[x]), for begin <= x < end.
float largest_difference(const float* a, const float* b, float factor, int begin, int end);

}  // namespace homolog
