// SPDX-License-Identifier: MIT
// Sec. 4.3: the octave pyramid of differences of Gaussians of chi.
// In: coverage voxels. Out: scale-normalised Laplacian responses, octave by octave.
// Differs: divided by ln k and read at the geometric mean scale, not by the paper's k (design: docs/paper_map.md).
#pragma once

#include <functional>
#include <vector>

#include "homolog/base/parameters.h"
#include "homolog/shape/volume.h"

namespace homolog {

/// One octave: levels[s] = (G(k sigma_s) - G(sigma_s)) * chi / ln k / (-0.925), the response as a share of a ball's, at scale sigmas[s] (world
/// units, geometric mean of the two blurs).
struct Octave {
  std::vector<Volume<float>> levels;
  std::vector<double> sigmas;
};

/// The response of a ball's centre at its own scale, sqrt(2/pi) 3 sqrt(3) exp(-3/2) = 0.925.
double ball_response();

/// Calls visit(octave) for every octave from fine to coarse; only one octave is held at a time.
void for_each_octave(const Interior& interior, const SalientParams& params, const std::function<void(const Octave&)>& visit);

}  // namespace homolog
