// SPDX-License-Identifier: MIT
// Makes the orientation of a surface consistent, so that winding numbers tell inside from outside.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

struct OrientedSurface {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of the mesh, turned; those with two corners in one place are left out
  bool closed;                                          ///< at every edge as many triangles run one way as the other
};

/// Turns triangles so that neighbours agree, and whole components so that solids have positive volume: a reversed component inside
/// another one stays, as its cavity. Components that are far from closed keep the orientation most of their triangles have in the file.
OrientedSurface orient(const Mesh& mesh);

}  // namespace homolog
