// SPDX-License-Identifier: MIT
// A mesh as a report draws it: welded, thinned where it is very large, and encoded for the page.
#pragma once

#include <nlohmann/json.hpp>

#include "homolog/shape/mesh.h"

namespace homolog {

/// The mesh with equal vertices made one and unused ones left out. Above `max_triangles` vertices are clustered (Rossignac and
/// Borrel 1993) until it fits: good to look at, not to measure on.
Mesh mesh_to_draw(const Mesh& mesh, std::size_t max_triangles = 60000);

/// { "centre", "positions": base64 of float32 triples relative to the centre, "indices": base64 of uint32 triples, "triangles": how
/// many the mesh itself has }, little-endian.
nlohmann::ordered_json mesh_for_page(const Mesh& mesh);

}  // namespace homolog
