// SPDX-License-Identifier: MIT
// glTF 2.0 as it is written: numbers in one buffer, the list of what lies in it, and a .glb of both.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

using Floats = std::vector<float>;

/// What a table is for, of glTF's numbers.
enum class GltfTarget { none = 0, vertices = 34962, triangles = 34963 };

/// The binary part of a file, and the list of what lies in it.
struct GltfContent {
  std::string bytes;
  nlohmann::ordered_json views = nlohmann::ordered_json::array(), accessors = nlohmann::ordered_json::array();
};

/// Adds bytes as a view and returns its number.
int add_view(GltfContent& content, std::string_view bytes, GltfTarget target);

/// Adds values of `columns` numbers each (1 to 4, or 16 for a matrix by columns) and returns the number of their accessor.
int add_table(GltfContent& content, const Floats& values, int columns, GltfTarget target);
int add_table(GltfContent& content, const std::vector<std::uint32_t>& values, int columns, GltfTarget target);
int add_table(GltfContent& content, const std::vector<std::uint16_t>& values, int columns, GltfTarget target);
int add_table(GltfContent& content, const std::vector<std::uint8_t>& values, int columns, GltfTarget target);

/// The same with the least and the most of every column, which glTF asks for of positions and times.
int add_bounded_table(GltfContent& content, const Floats& values, int columns, GltfTarget target);

/// Less `origin`, in single precision.
Floats floats_of(const std::vector<Vec3>& vectors, const Vec3& origin = Vec3::Zero());

Floats difference(const Floats& a, const Floats& b);

/// Normals of unit length, as glTF wants them, also where a vertex has no triangle; of triangles that are oriented already.
Floats unit_normals(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles);

/// Adds "asset", and "accessors", "bufferViews" and "buffers" of the content. The buffer lies in the file `uri`; empty: in the same one.
nlohmann::ordered_json gltf_document(const nlohmann::ordered_json& json, const GltfContent& content, const std::string& uri = "");

/// The .glb of a document and its buffer. Throws OutputError for one of 4 GiB or more.
std::string glb_bytes(const nlohmann::ordered_json& document, const GltfContent& content);

}  // namespace homolog
