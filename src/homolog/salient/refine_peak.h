// SPDX-License-Identifier: MIT
// Sec. 4.3: the place and scale of a minimum of L_norm below the voxel and the scale step.
// In: an octave and a voxel of one of its inner levels. Out: the salient point, without direction.
// Differs: quadratic steps that cannot run off, and a scale offset corrected by the exact curve of a ball (design: docs/paper_map.md).
#pragma once

#include <array>
#include <vector>

#include "homolog/salient/salient_point.h"
#include "homolog/salient/scale_space.h"

namespace homolog {

/// A voxel of an octave's level that no neighbour exceeds.
struct Peak {
  int level;
  std::array<int, 3> voxel;
};

/// Turns the offset of a parabola through three levels (in steps of log k) into the true one. A ball's curve is skew: without this its
/// radius comes out 1 to 4 % large.
class ScaleCorrection {
 public:
  explicit ScaleCorrection(double k);
  double operator()(double parabola_offset) const;

 private:
  std::vector<double> parabola_offsets_;  // of true offsets from -1 to 1 in even steps
};

/// A salient point without direction, and the share by which its response falls within r / 2 along the direction in which it bends second
/// to least: about 0 over an even plate, where the place of a peak is an accident of the grid. Along a limb one direction is even, too:
/// that is allowed.
struct RefinedPeak {
  SalientPoint point;
  double sheet_fall;
};

/// How many slices away from a peak its refinement may look.
int refinement_reach(const SalientParams& params);

/// `k` is the factor between levels.
RefinedPeak refine_peak(const Octave& octave, const Peak& peak, double k, const ScaleCorrection& correction);

}  // namespace homolog
