// SPDX-License-Identifier: MIT
// Rows that know which of their blocks are constant, and a volume of them that is made from bottom to top and of which only the newest
// slices are kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#include "homolog/salient/row_sums.h"
#include "homolog/shape/volume.h"

namespace homolog {

/// Rows of whole blocks, each beginning on a border of cache lines, in slots of `depth` rows that share the kinds of their blocks. Constant
/// blocks are written only when they have been something else before.
class BlockRows {
 public:
  BlockRows(int blocks, std::size_t slots, int depth, float plateau);

  int blocks() const { return static_cast<int>(blocks_); }
  float plateau() const { return plateau_; }
  const float* row(std::size_t slot, int n = 0) const { return values_[(slot * depth_ + n) * blocks_].values; }
  float* row(std::size_t slot, int n = 0) { return values_[(slot * depth_ + n) * blocks_].values; }
  const std::uint8_t* kinds(std::size_t slot) const { return &kinds_[slot * blocks_]; }

  /// Gives the blocks of a slot new kinds; mixed ones are then to be written.
  void begin(std::size_t slot, const std::uint8_t* kinds);
  /// Looks which mixed blocks of a slot's first row are constant.
  void settle(std::size_t slot);

 private:
  struct alignas(64) Block {
    float values[row_block];
  };
  std::size_t blocks_, depth_;
  float plateau_;
  struct Free {
    void operator()(Block* blocks) const;
  };
  std::unique_ptr<Block[], Free> values_;  // without a value until it is begun
  std::vector<std::uint8_t> kinds_;
};

/// Adds what other blocks may hold, eight at once.
inline void join_kinds(const std::uint8_t* more, int blocks, std::uint8_t* kinds) {
  int b = 0;
  for (; b + 8 <= blocks; b += 8) {
    std::uint64_t eight, other;
    std::memcpy(&eight, kinds + b, 8);
    std::memcpy(&other, more + b, 8);
    eight |= other;
    std::memcpy(kinds + b, &eight, 8);
  }
  for (; b < blocks; ++b) kinds[b] |= more[b];
}

/// Calls work(begin, end) for every run of mixed blocks, in floats.
template <class Work>
void for_mixed_runs(const std::uint8_t* kinds, int blocks, const Work& work) {
  for (int b = 0; b < blocks; ++b) {
    if (kinds[b] != mixed_block) continue;
    const int first = b;
    while (b < blocks && kinds[b] == mixed_block) ++b;
    work(first * row_block, b * row_block);
  }
}

/// Slice k takes the place of slice k - held. What lies beyond the frame's size in a row is 0.
class RollingVolume {
 public:
  RollingVolume(const GridFrame& frame, int held, float plateau);

  const GridFrame& frame() const { return frame_; }
  int blocks() const { return rows_.blocks(); }
  float plateau() const { return rows_.plateau(); }

  /// Row j of slice k, one of the newest `held` ones.
  const float* row(int j, int k) const { return rows_.row(slot(j, k)); }
  const std::uint8_t* kinds(int j, int k) const { return rows_.kinds(slot(j, k)); }

  /// The same row to be written where it is to be mixed, and its end once it is.
  float* begin_row(int j, int k, const std::uint8_t* kinds);
  void end_row(int j, int k);

  /// The rows from `first` on of column j, rows of zeros beyond the frame, and what their blocks may hold together.
  void column(int j, int first, std::vector<const float*>& rows, std::vector<std::uint8_t>& kinds) const;

 private:
  std::size_t slot(int j, int k) const { return static_cast<std::size_t>(k % held_) * frame_.size[1] + j; }

  GridFrame frame_;
  int held_;
  BlockRows rows_;
  std::size_t zeros_;  // the slot of a row of zeros
};

}  // namespace homolog
