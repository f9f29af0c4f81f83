// SPDX-License-Identifier: MIT
// Sec. 4: which salient points of a shape are found again in another form of it, and how many would be by chance.
#pragma once

#include <cstdint>
#include <vector>

#include "homolog/salient/salient_point.h"
#include "homolog/shape/volume.h"

namespace homolog::bench {

/// What counts as found again: within `place` of the reference's radius, and a radius within the share `scale` of it.
struct Tolerance {
  double place = 0.25, scale = 0.15;
};

/// The share (0 to 1) of the reference's points that are found again; 0 when it has none.
double repeated_share(const std::vector<SalientPoint>& reference, const std::vector<SalientPoint>& points, const Tolerance& tolerance = {});

/// The same for points with the radii of the given ones at places drawn evenly from the inside of the solid: the mean of `draws` draws.
double chance_share(const std::vector<SalientPoint>& reference, const std::vector<SalientPoint>& points, const Interior& interior,
                    int draws = 20, std::uint64_t seed = 1, const Tolerance& tolerance = {});

}  // namespace homolog::bench
