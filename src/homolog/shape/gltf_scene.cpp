// SPDX-License-Identifier: MIT
#include "homolog/shape/gltf_scene.h"

#include <fmt/format.h>

#include "homolog/shape/gltf_primitives.h"

namespace homolog {
namespace {

using nlohmann::json;

Mat4 local_matrix(const GltfFile& file, const json& node) {
  if (const auto matrix = floats_at(file, node, "matrix", 16)) return Eigen::Map<const Mat4>(matrix->data());
  return matrix_of(stated_pose(file, node));
}

bool hides_itself(const json& node) {
  const json& visibility = object_at(object_at(node, "extensions"), "KHR_node_visibility");
  const auto visible = visibility.find("visible");
  return visible != visibility.end() && *visible == false;
}

std::vector<std::size_t> nodes_at_the_top(const GltfFile& file, std::size_t count) {
  const auto scenes = file.document.find("scenes");
  if (scenes != file.document.end() && scenes->is_array() && !scenes->empty()) {
    return numbers_at(file, entry(file, "scenes", number_at(file, file.document, "scene").value_or(0)), "nodes");
  }
  std::vector<char> is_child(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::size_t child : numbers_at(file, entry(file, "nodes", i), "children")) {
      if (child < count) is_child[child] = true;
    }
  }
  std::vector<std::size_t> top;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_child[i]) top.push_back(i);
  }
  return top;
}

}  // namespace

Pose stated_pose(const GltfFile& file, const json& node) {
  Pose pose;
  const auto translation = floats_at(file, node, "translation", 3), rotation = floats_at(file, node, "rotation", 4),
             scale = floats_at(file, node, "scale", 3);
  if (translation) pose.shift = Eigen::Map<const Vec3>(translation->data());
  if (rotation) pose.turn.coeffs() = Eigen::Map<const Eigen::Vector4d>(rotation->data());
  pose.turn = pose.turn.squaredNorm() > 0 ? pose.turn.normalized() : Eigen::Quaterniond::Identity();
  if (scale) pose.scale = Eigen::Map<const Vec3>(scale->data());
  return pose;
}

std::vector<GltfNode> scene_nodes(const GltfFile& file) {
  const auto list = file.document.find("nodes");
  const std::size_t count = list != file.document.end() && list->is_array() ? list->size() : 0;
  std::vector<char> seen(count, false);
  std::vector<GltfNode> nodes;
  const auto add = [&](std::size_t number, std::optional<std::size_t> parent) {
    const json& node = entry(file, "nodes", number);
    if (seen[number]) fail(file, fmt::format("node {} stands in two places of its scene", number));
    seen[number] = true;
    const Mat4 local = local_matrix(file, node);
    const bool is_hidden = hides_itself(node) || (parent && nodes[*parent].is_hidden);
    nodes.push_back({number, parent, local, parent ? Mat4(nodes[*parent].world * local) : local, is_hidden});
  };
  for (const std::size_t number : nodes_at_the_top(file, count)) add(number, {});
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const std::size_t child : numbers_at(file, entry(file, "nodes", nodes[i].number), "children")) add(child, i);
  }
  return nodes;
}

}  // namespace homolog
