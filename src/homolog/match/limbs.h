// SPDX-License-Identifier: MIT
// Beyond the paper: a cloth is drawn to what lies near, so a limb laid too short stays too short, with its tip beside the data's skin.
// Where ends of both bodies belong together, each place on a limb is drawn to the places as far out on the data's.
#pragma once

#include <limits>
#include <vector>

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"

namespace homolog {

/// Ends of the model and of the data, pair by pair.
struct EndsTogether {
  std::vector<int> model, data;
};

/// Those that are each other's nearest where the cloth lies; none if fewer than three.
EndsTogether ends_together(const Cloth& cloth, const Shape& model, const Shape& data);

/// Where the ends lie when the body's nodes lie so; the most prominent ones, `most` of them at most.
std::vector<Vec3> places_of(const Ends& ends, const std::vector<Vec3>& nodes, std::size_t most = std::numeric_limits<std::size_t>::max());

/// Length of the way inside between two of a shape's ends.
double way_between(const Ends& ends, int a, int b);

/// Those of `first`, then those of `second`.
EndsTogether joined(EndsTogether first, const EndsTogether& second);

/// From each chosen end to where the ways to two others part, the nearest parting (their Gromov product): it stays when a body bends.
std::vector<double> limb_lengths(const Ends& ends, const std::vector<int>& chosen);

/// An end in another piece of the body, or beside another one, has none.
bool is_length(double length);

/// Where samples of a shape's skin lie on the limbs that end in the chosen ones of its ends, which number the limbs. Shares of a limb's
/// length are compared, so that a longer limb is longer evenly.
std::vector<LimbPlace> limb_places(const std::vector<SurfaceSample>& samples, const Shape& shape, const std::vector<int>& chosen);

}  // namespace homolog
