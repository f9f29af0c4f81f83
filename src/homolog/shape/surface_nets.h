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

/// Whether the surface stays as it is in the cell between the values from here to one further along each axis.
using IsStill = std::function<bool(const std::array<int, 3>& cell)>;

/// The surface in grid coordinates, whole numbers being the places of the values; outside the grid the field is 0. A vertex lies in each
/// cell between eight values that the surface passes, first at the mean of its crossings; then it is smoothed `rounds` times without
/// leaving its cell, which takes the stairs off a field of zeros and ones. What is many cells thick keeps its volume; what is one or two
/// cells thick would shrink: vertices of cells that are still lie in their middle, so that the surface keeps the volume of its voxels.
Mesh surface_nets(const SliceField& field, int rounds, const IsStill& is_still = {});

}  // namespace homolog
