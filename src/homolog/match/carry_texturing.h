// SPDX-License-Identifier: MIT
// Beyond the paper: UVs, and the materials with their pictures, carried from one mesh to the other by a dense map.
#pragma once

#include "homolog/match/dense.h"
#include "homolog/shape/attributes.h"

namespace homolog {

/// Where the receiver's triangles lie on the giver's pictures. A triangle whose three vertices have places lies where the place nearest to
/// the middle of these does: it takes the material of the giver's triangle there, and each corner its UV on the way from there to the
/// corner's place that crosses no seam. A corner beyond a seam gets the UV of the nearest place before it, so no triangle straddles two
/// islands, or the two sides of a cut. Other triangles have neither UVs nor a
/// material.
Texturing carry_texturing(const AttributedMesh& giver, const Mesh& receiver, const std::vector<DensePlace>& places);

/// For every triangle and its side from corner k to k + 1 the triangle beyond that belongs to the same island and material; none at seams
/// and borders. Vertices in one place are one.
struct IslandNeighbours {
  static constexpr std::uint32_t none = DensePlace::none;
  std::vector<std::array<std::uint32_t, 3>> beyond;
};
IslandNeighbours island_neighbours(const AttributedMesh& mesh);

}  // namespace homolog
