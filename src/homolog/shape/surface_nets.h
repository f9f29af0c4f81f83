// SPDX-License-Identifier: MIT
// The surface where a field on a grid falls below one half, closed and with its front outside [gibson1998].
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

/// A field on a grid, slice by slice: fills the values at z, x fastest.
struct SliceField {
  std::array<int, 3> size;
  std::function<void(int z, std::vector<float>& slice)> fill;
};

/// The surface in grid coordinates, whole numbers being the places of the values; outside the grid the field is 0. A vertex lies in each
/// cell between eight values that the surface passes, first at the mean of its crossings; then it is smoothed `rounds` times without
/// shrinking, but never leaves its cell: that takes the stairs off a field of zeros and ones.
Mesh surface_nets(const SliceField& field, int rounds);

}  // namespace homolog
