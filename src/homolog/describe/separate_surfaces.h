// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "homolog/describe/shape.h"

namespace homolog {

/// The numbers of the samples of each separate piece of a solid, best sampled first, `most` pieces at most; none if there is but one of 24
/// samples or more. `surface`: the samples of which the body joins the first.
std::vector<std::vector<int>> separate_surfaces(const std::vector<SurfaceSample>& surface, const Body& body, std::size_t most);

/// A piece of a shape as a shape of its own.
struct Piece {
  Shape shape;              ///< with the interior of the whole, and descriptors that know the whole
  std::vector<int> points;  ///< their numbers in the whole
};

/// `samples`: of one of separate_surfaces(), in ascending order.
Piece piece_of(const Shape& whole, const std::vector<int>& samples);

}  // namespace homolog
