// SPDX-License-Identifier: MIT
// Sec. 4.3: the octave pyramid of differences of Gaussians of chi.
// In: coverage voxels. Out: scale-normalised Laplacian responses, octave by octave.
// Differs: divided by ln k and read at the geometric mean scale, not by the paper's k (design: docs/paper_map.md).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "homolog/base/parameters.h"
#include "homolog/salient/rolling_volume.h"
#include "homolog/shape/volume.h"

namespace homolog {

/// A voxel of coverage has already been averaged over a box: its variance, in voxels squared.
inline constexpr double coverage_variance = 1.0 / 12;

/// One octave of S + 2 levels on one grid, L_norm as a share of a ball's: level i is (G(k s_i) - G(s_i)) * chi / ln k / ball_response(k)
/// at sigmas[i] = s_i sqrt(k), in world units. Minima of L_norm are maxima here. Levels 1 to S belong to this octave; level 0 repeats
/// the octave below and level S + 1 begins the one above. It is never there as a whole: see for_each_octave.
struct Octave {
  std::span<const RollingVolume> blurred;  ///< G(s_i) * chi; one more than levels
  float factor = 0;                        ///< of a level: -1 / (ln k ball_response(k))
  std::vector<double> sigmas;
  int first = 0, end = 0;  ///< the slices first <= k < end are new

  const GridFrame& frame() const { return blurred[0].frame(); }
  int levels() const { return static_cast<int>(blurred.size()) - 1; }
  float at(int level, int i, int j, int k) const { return factor * (blurred[level].row(j, k)[i] - blurred[level + 1].row(j, k)[i]); }
};

/// (G(k s) - G(s)) * chi / ln k in the centre of a unit ball, read at sigma = s sqrt(k); tends to -sqrt(2/pi) sigma^-3 exp(-1/(2 sigma^2)).
double ball_level(double sigma, double k);

/// The scale at which a ball of radius r answers strongest is r / radius_factor(k): sqrt(3 ln k / sinh ln k), sqrt(3) in the limit.
double radius_factor(double k);

/// The ball's strongest response, ball_level(1 / radius_factor(k), k); tends to -sqrt(2/pi) 3 sqrt(3) exp(-3/2) = -0.925.
double ball_response(double k);

/// Calls visit(octave) for every octave from fine to coarse, until a ball as large as the shape's box is covered. Each is visited several
/// times, from bottom to top: its new slices and those within `reach` of them are held then, in all levels.
void for_each_octave(const Interior& interior, const SalientParams& params, int reach, const std::function<void(const Octave&)>& visit);

}  // namespace homolog
