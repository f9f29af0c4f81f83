// SPDX-License-Identifier: MIT
#include "homolog/salient/rolling_volume.h"

#include <algorithm>

namespace homolog {

RollingVolume::RollingVolume(const GridFrame& frame, int held)
    : frame_(frame),
      held_(std::min(held, frame.size[2])),
      stride_((frame.size[0] + row_block - 1) / row_block * row_block),
      blocks_per_row_(static_cast<std::size_t>(stride_) / row_block),
      blocks_(blocks_per_row_ * (static_cast<std::size_t>(held_) * frame.size[1] + 1)),
      runs_(static_cast<std::size_t>(held_) * frame.size[1]) {}

float* RollingVolume::begin_row(int j, int k, const Run& run) {
  float* row = blocks_[slot(j, k) * blocks_per_row_].values;
  Run& old = runs_[slot(j, k)];
  if (!old.empty()) std::fill(row + block_begin(old), row + block_end(old), 0.0f);
  old = run;
  return row;
}

float* RollingVolume::change_row(int j, int k, const Run& run) {
  runs_[slot(j, k)] = run;
  return blocks_[slot(j, k) * blocks_per_row_].values;
}

Run RollingVolume::column(int j, int k, std::vector<const float*>& rows) const {
  const int radius = static_cast<int>(rows.size()) / 2, first = std::max(0, k - radius), last = std::min(frame_.size[2] - 1, k + radius);
  std::fill(rows.begin(), rows.end(), blocks_[blocks_.size() - blocks_per_row_].values);
  Run all;
  for (int z = first, slice = first % held_; z <= last; ++z, slice = slice + 1 == held_ ? 0 : slice + 1) {
    const std::size_t slot = static_cast<std::size_t>(slice) * frame_.size[1] + j;
    rows[z - k + radius] = blocks_[slot * blocks_per_row_].values;
    all = joined(all, runs_[slot]);
  }
  return all;
}

}  // namespace homolog
