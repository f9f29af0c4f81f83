// SPDX-License-Identifier: MIT
// A mesh as a report draws it: welded, thinned where it is very large, and encoded for the page.
#pragma once

#include <nlohmann/json.hpp>

#include "homolog/shape/cluster_vertices.h"

namespace homolog {

/// The mesh with equal vertices made one and unused ones left out. Above `max_triangles` vertices are clustered until it fits:
/// good to look at, not to measure on.
ClusteredMesh mesh_to_draw(const Mesh& mesh, std::size_t max_triangles = 60000);

/// { "centre", "positions": base64 of float32 triples relative to the centre, "indices": base64 of uint32 triples, "triangles": how
/// many the mesh itself has }, little-endian.
nlohmann::ordered_json mesh_for_page(const Mesh& mesh, const ClusteredMesh& drawn);

/// Weights of the mesh's own vertices (0 to 1) as base64 of one byte for each drawn vertex: 255 times the mean over what became it.
std::string weights_for_page(const ClusteredMesh& drawn, const std::vector<float>& weights);

}  // namespace homolog
