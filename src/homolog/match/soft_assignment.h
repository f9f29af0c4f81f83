// SPDX-License-Identifier: MIT
// Beyond the paper: which samples of the data a skin is drawn to, softly and both ways, as in robust point matching (Chui & Rangarajan
// 2003).
#pragma once

#include <vector>

#include "homolog/describe/sample_blocks.h"

namespace homolog {

/// What the data's samples ask of every place of a skin.
struct Pull {
  std::vector<Vec3> places;    ///< mean of its samples, laid on its tangent plane as below; zero where there are none
  std::vector<double> masses;  ///< how strongly, 0 to about 1
};

/// A place and a sample weigh max(0, exp(-distance^2 / (2 reach^2) - away^2 / 2) - e^-12) max(0, n . n')^2, which falls to nothing without
/// a step where samples are too far to be looked at. Along limbs, if their places are told, away^2 = o^2 + o'^2, less 2 o o' on the same
/// limb, for o and o' as far out; else it is 0. The weights are normalised by place and by sample, each with a tenth of the mean sum for
/// what has no partner, and the mean of both is taken. A sample x counts as x + n (x - y) . (n' - n) / 2 for a place y: on a round surface
/// that is y's tangent plane, where x alone lies below it by the sagitta and would draw y inwards (the symmetric distance of Rusinkiewicz
/// 2019).
Pull assign_softly(const std::vector<SurfaceSample>& skin, const SampleBlocks& data, double reach,
                   const std::vector<LimbPlace>& limb_places = {});

}  // namespace homolog
