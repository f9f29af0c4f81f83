// SPDX-License-Identifier: MIT
// Sec. 4.1: convolution of a volume with the Gaussian G(x, sigma), axis by axis, zero outside; slice by slice, so that what a sum needs
// is still in the cache and memory is needed for a few slices only.
// Differs: the 3D normalisation (2 pi sigma^2)^(-3/2), not the printed 2D one; the sampled kernel has exactly the variance sigma^2.
#pragma once

#include <functional>
#include <vector>

#include "homolog/salient/rolling_volume.h"

namespace homolog {

/// Half of a sampled Gaussian: weights[t] for offsets t and -t; they sum to 1 over both sides and have variance sigma^2 (in voxels).
std::vector<float> gaussian_kernel(double sigma);

/// Blurs a volume by `sigma` voxels while it is being made. Empty runs of rows are skipped; bytes do not depend on the number of threads
/// or on how many slices are handed over at a time.
class RollingBlur {
 public:
  /// At most `chunk` slices are taken and given at a time.
  RollingBlur(const GridFrame& frame, double sigma, int chunk);

  int radius() const { return static_cast<int>(weights_.size()) - 1; }
  int taken() const { return taken_; }

  /// Takes the next slices of the volume, up to but without `end`.
  void take(const RollingVolume& volume, int end);

  /// How many blurred slices can be given after what was taken.
  int ready() const;

  /// Writes the blurred slices first <= k < end, in order over all calls, and calls done(j, k) for every row of them.
  void give(int first, int end, RollingVolume& blurred, const std::function<void(int, int)>& done) const;

 private:
  void blur_slice(const RollingVolume& volume, int k);

  std::vector<float> weights_;
  RollingVolume flat_;  // blurred along x and y
  int taken_ = 0;
};

}  // namespace homolog
