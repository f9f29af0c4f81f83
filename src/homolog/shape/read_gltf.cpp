// SPDX-License-Identifier: MIT
#include "homolog/shape/read_gltf.h"

#include <algorithm>

#include "homolog/shape/gltf_primitives.h"
#include "homolog/shape/gltf_scene.h"

namespace homolog {
namespace {

void append(Mesh& mesh, const GltfFile& file, const nlohmann::json& primitive, const Mat4& world, std::size_t most_triangles) {
  const GltfTable positions = positions_of(file, primitive);
  const std::size_t first = mesh.vertices.size();
  check_count(file, mesh.triangles.size(), first + positions.rows, most_triangles);
  for (std::size_t i = 0; i < positions.rows; ++i) {
    mesh.vertices.push_back((world * positions.vec3(i).homogeneous()).head<3>());
    if (!mesh.vertices.back().allFinite()) fail(file, "a coordinate is not a finite number");
  }
  const auto triangles = triangles_of(file, primitive, positions.rows, static_cast<std::uint32_t>(first));
  check_count(file, mesh.triangles.size() + triangles.size(), first + positions.rows, most_triangles);
  mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
}

}  // namespace

bool is_gltf(std::string_view content) {
  if (is_glb(content)) return true;
  content.remove_prefix(std::min(content.find_first_not_of(" \t\r\n"), content.size()));
  return content.starts_with('{') && content.find("\"asset\"") != content.npos;
}

Mesh read_gltf(std::string_view content, const std::string& file, const FindOther& find_other, std::size_t most_triangles) {
  const GltfFile gltf = read_gltf_file(content, file, find_other);
  Mesh mesh;
  for (const GltfNode& node : scene_nodes(gltf)) {
    const auto number = number_at(gltf, entry(gltf, "nodes", node.number), "mesh");
    if (!number) continue;
    for (const nlohmann::json& primitive : list_at(entry(gltf, "meshes", *number), "primitives")) {
      if (draws_triangles(gltf, primitive)) append(mesh, gltf, primitive, node.world, most_triangles);
    }
  }
  return mesh;
}

}  // namespace homolog
