// SPDX-License-Identifier: MIT
// What glTF files draw: lists of vertices, as triangles, strips or fans.
#pragma once

#include "homolog/shape/gltf_table.h"
#include "homolog/shape/mesh.h"

namespace homolog {

/// The value of a key, or an empty object or list if there is none of that kind.
const nlohmann::json& object_at(const nlohmann::json& object, const char* key);
const nlohmann::json& list_at(const nlohmann::json& object, const char* key);

/// False for points and lines.
bool draws_triangles(const GltfFile& file, const nlohmann::json& primitive);

/// The vertices of a primitive, three times `most_triangles` at most. Throws FileError.
GltfTable positions_of(const GltfFile& file, const nlohmann::json& primitive, std::size_t most_triangles);

/// The triangles of a primitive that has so many vertices, the first of them being number `first`. Throws FileError.
std::vector<Triangle> triangles_of(const GltfFile& file, const nlohmann::json& primitive, std::size_t vertices, std::uint32_t first);

/// Throws FileError for more than `most_triangles`, or three times as many vertices.
void check_count(const GltfFile& file, std::size_t triangles, std::size_t vertices, std::size_t most_triangles);

}  // namespace homolog
