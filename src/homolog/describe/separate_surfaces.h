// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "homolog/describe/body.h"

namespace homolog {

/// The samples of each separate piece of a solid, best sampled first, `most` pieces at most; none if there is but one of 24 samples or
/// more. `surface`: the samples of which the body joins the first.
std::vector<std::vector<SurfaceSample>> separate_surfaces(const std::vector<SurfaceSample>& surface, const Body& body, std::size_t most);

}  // namespace homolog
