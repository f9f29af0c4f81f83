// SPDX-License-Identifier: MIT
// Sec. 4.1: convolution of a volume with the Gaussian G(x, sigma), axis by axis, zero outside.
// Differs: the 3D normalisation (2 pi sigma^2)^(-3/2), not the printed 2D one; the sampled kernel has exactly the variance sigma^2.
#pragma once

#include <vector>

#include "homolog/shape/volume.h"

namespace homolog {

/// Half of a sampled Gaussian: weights[t] for offsets t and -t; they sum to 1 over both sides and have variance sigma^2 (in voxels).
std::vector<float> gaussian_kernel(double sigma);

/// The volume blurred by `sigma` voxels. Empty runs of rows are skipped; bytes do not depend on the number of threads.
Volume<float> gaussian_blur(const Volume<float>& volume, double sigma);

}  // namespace homolog
