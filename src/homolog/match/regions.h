// SPDX-License-Identifier: MIT
// Beyond the paper: regions of a body's skin, by which a part is laid on a whole. A region is what lies within a way inside from a place
// on the skin.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "homolog/describe/body.h"
#include "homolog/match/settled_skins.h"

namespace homolog {

struct Region {
  std::size_t centre = 0;  ///< a node of the body
  AxisSkin skin;
};

/// The longest finite way inside from a node to the skin.
double longest_way_from(const Body& body, std::size_t node);

/// The longest one from any of the first samples of the skin, which are even.
double longest_way(const Body& body);

/// The regions about each of the first `centres` samples, which reach as far as each of `reaches`, shares of the longest way. None that is
/// too small to show a form, or about the whole skin.
std::vector<Region> regions_of(const Body& body, std::size_t centres, std::span<const double> reaches);

}  // namespace homolog
