// SPDX-License-Identifier: MIT
#include "homolog/salient/rolling_volume.h"

#include <algorithm>
#include <cstdlib>
#include <new>

#include "homolog/base/large_memory.h"

namespace homolog {

namespace {

// Beginning on a border of huge pages when it is large.
void* aligned_memory(std::size_t bytes) {
  const std::size_t border = bytes < huge_page ? 64 : huge_page;
  void* memory = std::aligned_alloc(border, (bytes + border - 1) / border * border);
  if (!memory) throw std::bad_alloc();
  prefer_huge_pages(memory, bytes);
  return memory;
}

}  // namespace

BlockRows::BlockRows(int blocks, std::size_t slots, int depth, float plateau)
    : blocks_(blocks),
      depth_(depth),
      plateau_(plateau),
      values_(static_cast<Block*>(aligned_memory(slots * depth * blocks * sizeof(Block)))),
      kinds_(slots * blocks, unset_block) {}

void BlockRows::Free::operator()(Block* blocks) const { std::free(blocks); }

void BlockRows::begin(std::size_t slot, const std::uint8_t* kinds) {
  std::uint8_t* old = &kinds_[slot * blocks_];
  if (std::equal(old, old + blocks_, kinds)) return;
  for (std::size_t b = 0; b < blocks_; ++b) {
    if (old[b] == kinds[b]) continue;
    old[b] = kinds[b];
    if (kinds[b] == mixed_block) continue;
    const float value = kinds[b] == empty_block ? 0 : plateau_;
    for (std::size_t n = 0; n < depth_; ++n) std::fill_n(values_[(slot * depth_ + n) * blocks_ + b].values, row_block, value);
  }
}

void BlockRows::settle(std::size_t slot) {
  std::uint8_t* kinds = &kinds_[slot * blocks_];
  const float* values = row(slot);
  for (std::size_t b = 0; b < blocks_; ++b) {
    if (kinds[b] == mixed_block) kinds[b] = kind_of(values + b * row_block, plateau_);
  }
}

RollingVolume::RollingVolume(const GridFrame& frame, int held, float plateau)
    : frame_(frame),
      held_(std::min(held, frame.size[2])),
      rows_((frame.size[0] + row_block - 1) / row_block, static_cast<std::size_t>(held_) * frame.size[1] + 1, 1, plateau),
      zeros_(static_cast<std::size_t>(held_) * frame.size[1]) {
  rows_.begin(zeros_, std::vector<std::uint8_t>(blocks(), empty_block).data());
}

float* RollingVolume::begin_row(int j, int k, const std::uint8_t* kinds) {
  rows_.begin(slot(j, k), kinds);
  return rows_.row(slot(j, k));
}

void RollingVolume::end_row(int j, int k) {
  float* row = rows_.row(slot(j, k));
  std::fill(row + frame_.size[0], row + blocks() * row_block, 0.0f);
  rows_.settle(slot(j, k));
}

void RollingVolume::column(int j, int first, std::vector<const float*>& rows, std::vector<std::uint8_t>& kinds) const {
  const bool inside = j >= 0 && j < frame_.size[1];
  std::fill_n(kinds.begin(), blocks(), unset_block);
  int place = (first % held_ + held_) % held_;  // of slice k
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const int k = first + static_cast<int>(n);
    const std::size_t from = inside && k >= 0 && k < frame_.size[2] ? static_cast<std::size_t>(place) * frame_.size[1] + j : zeros_;
    if (++place == held_) place = 0;
    rows[n] = rows_.row(from);
    join_kinds(rows_.kinds(from), blocks(), kinds.data());
  }
}

}  // namespace homolog
