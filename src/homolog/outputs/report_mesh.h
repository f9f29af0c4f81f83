// SPDX-License-Identifier: MIT
// A mesh as a report draws it: welded, thinned where it is very large, and encoded for the page.
#pragma once

#include <nlohmann/json.hpp>

#include "homolog/shape/mesh.h"

namespace homolog {

struct DrawnMesh {
  static constexpr std::uint32_t nowhere = 0xffffffff;
  Mesh mesh;
  std::vector<std::uint32_t> drawn_vertex;  ///< of every vertex of the mesh itself; nowhere for one that no triangle uses
};

/// The mesh with equal vertices made one and unused ones left out. Above `max_triangles` vertices are clustered (Rossignac and
/// Borrel 1993) until it fits: good to look at, not to measure on.
DrawnMesh mesh_to_draw(const Mesh& mesh, std::size_t max_triangles = 60000);

/// { "centre", "positions": base64 of float32 triples relative to the centre, "indices": base64 of uint32 triples, "triangles": how
/// many the mesh itself has }, little-endian.
nlohmann::ordered_json mesh_for_page(const Mesh& mesh, const DrawnMesh& drawn);

/// Weights of the mesh's own vertices (0 to 1) as base64 of one byte for each drawn vertex: 255 times the mean over what became it.
std::string weights_for_page(const DrawnMesh& drawn, const std::vector<float>& weights);

}  // namespace homolog
