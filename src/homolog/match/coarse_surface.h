// SPDX-License-Identifier: MIT
// The surface at which a match's coverage is asked for: the mesh's own, or a coarser one of it where that has too many vertices.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

struct CoarseSurface {
  /// A place of the coarse mesh: between three of its vertices, with shares of the first two.
  struct Place {
    std::array<std::uint32_t, 3> corners;
    std::array<float, 2> shares;
  };
  Mesh mesh;
  std::vector<Vec3> normals;  ///< of its vertices, outward
  std::vector<Place> places;  ///< where the vertices of the mesh itself lie on it; none when it is that mesh
};

/// The mesh itself with its normals if it has no more than `most` vertices, else its vertices clustered in cells of this size.
CoarseSurface coarse_surface(const Mesh& mesh, double cell, std::size_t most);

/// What the vertices of the mesh itself have, from what those of the coarse one have: linear between these, and 0 where no triangle is.
std::vector<float> values_between(const CoarseSurface& surface, std::vector<float> values);

}  // namespace homolog
