// SPDX-License-Identifier: MIT
// Makes the orientation of a surface consistent, so that winding numbers tell inside from outside.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

struct OrientedSurface {
  std::vector<Triangle> triangles;  ///< of the mesh, turned, without copies and those with two corners in one place
  std::size_t components = 0;       ///< pieces whose triangles hang together by edges that two of them share
  double open = 0;                  ///< share (0 to 1) of the triangles' sides that none runs back along: 0 if closed
  bool closed() const { return open == 0; }
};

/// Welds vertices at equal places, and at open seams those a hundred-thousandth of the diagonal apart, where the triangles are much larger.
/// Turns triangles so that neighbours agree, and whole components so that solids have positive volume: a reversed component inside
/// another one stays, as its cavity. Components that are far from closed keep the orientation most of their triangles have in the file.
/// Of triangles with the same corners and front one is kept; of a surface that has every triangle with both fronts, one side.
OrientedSurface orient(const Mesh& mesh);

}  // namespace homolog
