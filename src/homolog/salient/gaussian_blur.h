// SPDX-License-Identifier: MIT
// Sec. 4.1: convolution of a volume with the Gaussian G(x, sigma), axis by axis, zero outside; a few slices at a time, so that what a sum
// needs is in the cache. Where all that a sum reaches is constant, so is the sum, and none is made.
// Differs: the 3D normalisation (2 pi sigma^2)^(-3/2), not the printed 2D one; the sampled kernel has exactly the variance sigma^2.
#pragma once

#include <functional>
#include <vector>

#include "homolog/salient/rolling_volume.h"

namespace homolog {

/// Half of a sampled Gaussian: weights[t] for offsets t and -t; they sum to 1 over both sides and have variance sigma^2 (in voxels).
std::vector<float> gaussian_kernel(double sigma);

/// A blur by `sigma` voxels. Every blurred value is the sum over z, then y, then x.
class GaussianBlur {
 public:
  explicit GaussianBlur(double sigma);

  int radius() const { return weights_.radius(); }

  /// What a plateau of this height is blurred: the same, but for rounding. It must be that of blurred volumes.
  float plateau_after(float plateau) const;

  /// Writes the rows first_row <= j < end_row of the blurred slices from `first` on, row_group of them or as many as there are, and calls
  /// done(j, k) for each. The slices from first - radius to first + row_group - 1 + radius, as far as there are any, must be held.
  void blur_rows(const RollingVolume& volume, int first, int first_row, int end_row, RollingVolume& blurred,
                 const std::function<void(int, int)>& done) const;

 private:
  RowWeights weights_;
};

}  // namespace homolog
