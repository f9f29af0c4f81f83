// SPDX-License-Identifier: MIT
#include "homolog/shape/gltf_instance.h"

namespace homolog {
namespace {

using nlohmann::json;

std::vector<double> weights_of(const json& node, const json& mesh) {
  std::vector<double> weights;
  for (const json& weight : list_at(node.contains("weights") ? node : mesh, "weights")) {
    weights.push_back(weight.is_number() ? weight.get<double>() : 0);
  }
  return weights;
}

}  // namespace

std::optional<GltfInstance> instance_of(const GltfFile& file, const GltfNode& node, GltfRig& rig) {
  const json& content = entry(file, "nodes", node.number);
  const auto number = number_at(file, content, "mesh");
  if (!number || node.is_hidden) return {};
  const json& mesh = entry(file, "meshes", *number);
  const char* instancing = "EXT_mesh_gpu_instancing";  // whether required or not: the node shows its mesh several times
  if (object_at(content, "extensions").contains(instancing)) refuse_extension(file, instancing);
  GltfInstance instance{node.number, mesh, node.world, {}, weights_of(content, mesh)};
  if (const auto skin = number_at(file, content, "skin")) instance.skin = rig.add_skin(*skin);
  return instance;
}

Mat4 GltfPlacing::at(std::size_t vertex) const {
  if (of_joints.empty() || !(influences[vertex][0].weight > 0)) return all;
  Mat4 sum = Mat4::Zero();
  double weights = 0;  // in single precision they do not quite sum to 1
  for (const Influence& influence : influences[vertex]) {
    if (!(influence.weight > 0)) break;
    sum += influence.weight * of_joints[influence.joint];
    weights += influence.weight;
  }
  return sum / weights;
}

GltfPlacing placing_of(const GltfFile& file, const GltfInstance& instance, const json& primitive, std::size_t vertices) {
  GltfPlacing placing{instance.world, {}, {}};
  const json& attributes = object_at(primitive, "attributes");
  if (!instance.skin || !attributes.contains("JOINTS_0")) return placing;
  GltfInfluences read = read_gltf_influences(file, attributes, vertices, instance.skin->joints);
  placing.influences = std::move(read.of_vertices);
  placing.has_weaker_weights = read.has_more;
  placing.all = instance.skin->first;
  placing.of_joints = instance.skin->of_joints;
  return placing;
}

std::optional<GltfTable> target_of(const GltfFile& file, const json& target, std::size_t vertices) {
  const auto positions = number_at(file, target, "POSITION");
  if (!positions) return {};
  return read_gltf_table(file, *positions, {"target's POSITION", {3}, vertices});
}

std::vector<Vec3> placed_vertices(const GltfFile& file, const GltfInstance& instance, const json& primitive, const GltfTable& positions,
                                  const GltfPlacing& placing) {
  std::vector<Vec3> vertices;
  vertices.reserve(positions.rows);
  for (std::size_t i = 0; i < positions.rows; ++i) vertices.push_back(positions.vec3(i));
  const json& targets = list_at(primitive, "targets");
  for (std::size_t k = 0; k < targets.size() && k < instance.weights.size(); ++k) {
    if (instance.weights[k] == 0) continue;
    const auto table = target_of(file, targets[k], positions.rows);
    for (std::size_t i = 0; table && i < vertices.size(); ++i) vertices[i] += instance.weights[k] * table->vec3(i);
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    vertices[i] = (placing.at(i) * vertices[i].homogeneous()).head<3>();
    if (!vertices[i].allFinite()) fail(file, "a coordinate is not a finite number");
  }
  return vertices;
}

}  // namespace homolog
