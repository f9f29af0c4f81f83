// SPDX-License-Identifier: MIT
#include "homolog/shape/read_gltf.h"

#include <algorithm>

#include "homolog/shape/gltf_instance.h"

namespace homolog {
namespace {

void append(Mesh& mesh, const GltfFile& file, const GltfInstance& instance, const nlohmann::json& primitive, std::size_t most_triangles) {
  const GltfTable positions = positions_of(file, primitive, most_triangles);
  const std::size_t first = mesh.vertices.size();
  check_count(file, mesh.triangles.size(), first + positions.rows, most_triangles);
  const auto vertices = placed_vertices(file, instance, primitive, positions, placing_of(file, instance, primitive, positions.rows));
  mesh.vertices.insert(mesh.vertices.end(), vertices.begin(), vertices.end());
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
  const std::vector<GltfNode> nodes = scene_nodes(gltf);
  GltfRig rig(gltf, nodes);
  Mesh mesh;
  for (const GltfNode& node : nodes) {
    const auto instance = instance_of(gltf, node, rig);
    if (!instance) continue;
    for (const nlohmann::json& primitive : list_at(instance->mesh, "primitives")) {
      if (draws_triangles(gltf, primitive)) append(mesh, gltf, *instance, primitive, most_triangles);
    }
  }
  return mesh;
}

}  // namespace homolog
