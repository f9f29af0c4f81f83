// SPDX-License-Identifier: MIT
#include "homolog/shape/gltf_primitives.h"

#include <fmt/format.h>

#include "homolog/base/errors.h"

namespace homolog {
namespace {

using nlohmann::json;

enum : std::size_t { kTriangles = 4, kStrip = 5, kFan = 6 };

std::size_t mode_of(const GltfFile& file, const json& primitive) { return number_at(file, primitive, "mode").value_or(kTriangles); }

/// 0, 1, 2, 3 ... if it has no indices.
std::vector<double> indices_of(const GltfFile& file, const json& primitive, std::size_t vertices) {
  if (const auto indices = number_at(file, primitive, "indices")) return read_gltf_table(file, *indices, {"indices", {1}, {}}).values;
  std::vector<double> numbers(vertices);
  for (std::size_t i = 0; i < vertices; ++i) numbers[i] = static_cast<double>(i);
  return numbers;
}

}  // namespace

const json& object_at(const json& object, const char* key) {
  static const json none = json::object();
  const auto found = object.find(key);
  return found != object.end() && found->is_object() ? *found : none;
}

const json& list_at(const json& object, const char* key) {
  static const json none = json::array();
  const auto found = object.find(key);
  return found != object.end() && found->is_array() ? *found : none;
}

bool draws_triangles(const GltfFile& file, const json& primitive) {
  const std::size_t mode = mode_of(file, primitive);
  return mode == kTriangles || mode == kStrip || mode == kFan;
}

GltfTable positions_of(const GltfFile& file, const json& primitive, std::size_t most_triangles) {
  const auto number = number_at(file, object_at(primitive, "attributes"), "POSITION");
  if (!number) fail(file, "a mesh has no POSITION");
  const json& accessor = entry(file, "accessors", *number);
  if (accessor.contains("bufferView")) return read_gltf_table(file, *number, {"POSITION", {3}, {}});
  for (const auto& [name, content] : object_at(primitive, "extensions").items()) {
    if (name.ends_with("_compression")) refuse_extension(file, name);
  }
  if (!accessor.contains("sparse")) fail(file, "its POSITION has no data");
  const std::size_t rows = number_at(file, accessor, "count").value_or(0);
  check_count(file, 0, rows, most_triangles);  // before they take memory, for which no bytes of the file stand
  return read_gltf_table(file, *number, {"POSITION", {3}, rows});
}

std::vector<Triangle> triangles_of(const GltfFile& file, const json& primitive, std::size_t vertices, std::uint32_t first) {
  const std::vector<double> indices = indices_of(file, primitive, vertices);
  for (const double index : indices) {
    if (!(index >= 0 && index < static_cast<double>(vertices))) {
      fail(file, fmt::format("a triangle names vertex {} of {}", index, vertices));
    }
  }
  std::vector<Triangle> triangles;
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    const auto at = [&](std::size_t i) { return first + static_cast<std::uint32_t>(indices[i]); };
    triangles.push_back({at(a), at(b), at(c)});
  };
  const std::size_t mode = mode_of(file, primitive), step = mode == kTriangles ? 3 : 1;
  for (std::size_t i = 0; i + 3 <= indices.size(); i += step) {
    if (mode == kFan) {
      add(0, i + 1, i + 2);
    } else {
      const bool turned = mode == kStrip && i % 2 == 1;
      add(i, i + (turned ? 2 : 1), i + (turned ? 1 : 2));
    }
  }
  return triangles;
}

void check_count(const GltfFile& file, std::size_t triangles, std::size_t vertices, std::size_t most_triangles) {
  if (triangles <= most_triangles && vertices <= 3 * most_triangles) return;
  throw FileError(fmt::format("{}: it holds more than the {} triangles that are read; simplify the mesh", file.name, most_triangles));
}

}  // namespace homolog
