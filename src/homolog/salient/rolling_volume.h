// SPDX-License-Identifier: MIT
// A volume that is made from bottom to top and of which only the newest slices are kept.
#pragma once

#include <algorithm>
#include <vector>

#include "homolog/salient/row_sums.h"
#include "homolog/shape/volume.h"

namespace homolog {

/// The part of a row that may be nonzero: [low, high).
struct Run {
  int low = 0, high = 0;
  bool empty() const { return low >= high; }
};

/// The smallest run that holds both.
inline Run joined(const Run& a, const Run& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

/// Slice k takes the place of slice k - held. Rows start on borders of cache lines and are padded to whole blocks (row_block).
class RollingVolume {
 public:
  RollingVolume(const GridFrame& frame, int held);

  const GridFrame& frame() const { return frame_; }
  int stride() const { return stride_; }

  /// Row j of slice k, one of the newest `held` ones. What lies beyond the frame's size has no meaning.
  const float* row(int j, int k) const { return blocks_[slot(j, k) * blocks_per_row_].values; }
  const Run& run(int j, int k) const { return runs_[slot(j, k)]; }

  /// The same row to be written within `run`, in whole blocks; everywhere else it is 0 from now on.
  float* begin_row(int j, int k, const Run& run);
  /// The same row to be changed within `run`, which holds the row's own.
  float* change_row(int j, int k, const Run& run);

  /// Fills in the rows k - radius to k + radius of column j, rows of zeros beyond the frame, and returns the run of all of them.
  Run column(int j, int k, std::vector<const float*>& rows) const;

 private:
  struct alignas(64) Block {
    float values[row_block];
  };
  std::size_t slot(int j, int k) const { return static_cast<std::size_t>(k % held_) * frame_.size[1] + j; }

  GridFrame frame_;
  int held_, stride_;
  std::size_t blocks_per_row_;
  std::vector<Block> blocks_;  // the last row stays 0
  std::vector<Run> runs_;
};

/// Borders of the whole blocks that hold a run.
inline int block_begin(const Run& run) { return run.low / row_block * row_block; }
inline int block_end(const Run& run) { return (run.high + row_block - 1) / row_block * row_block; }

}  // namespace homolog
