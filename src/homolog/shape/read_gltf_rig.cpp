// SPDX-License-Identifier: MIT
#include "homolog/shape/read_gltf_rig.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <limits>

#include "homolog/shape/gltf_table.h"

namespace homolog {

std::vector<std::uint16_t> GltfRig::add_skin(std::size_t number, const Mat4& world) {
  const nlohmann::json& skin = entry(file_, "skins", number);
  const std::vector<std::size_t> nodes = numbers_at(file_, skin, "joints");
  const auto matrices = number_at(file_, skin, "inverseBindMatrices");
  GltfTable table;
  if (matrices) table = read_gltf_table(file_, *matrices, {"inverse bind matrices", {16}, {}});
  if (matrices && table.rows < nodes.size()) fail(file_, fmt::format("skin {} has fewer inverse bind matrices than joints", number));
  std::vector<std::uint16_t> numbers;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Mat4 inverse = matrices ? Mat4(Eigen::Map<const Mat4>(table.values.data() + 16 * i)) : Mat4(Mat4::Identity());
    const Mat4 bind = world * inverse.inverse();
    if (!bind.allFinite()) fail(file_, fmt::format("joint {} of skin {} has a bind matrix without inverse", i, number));
    const auto [found, is_new] = number_of_.try_emplace(nodes[i], static_cast<std::uint16_t>(joints_.size()));
    numbers.push_back(found->second);
    if (is_new) {
      joints_.push_back({text_at(entry(file_, "nodes", nodes[i]), "name"), -1, bind});
    } else {
      bound_twice_ |= !joints_[found->second].bind.isApprox(bind, 1e-4);
    }
    if (joints_.size() > std::numeric_limits<std::uint16_t>::max()) fail(file_, "it has more joints than weights can name");
  }
  return numbers;
}

std::vector<Joint> GltfRig::joints() const {
  std::vector<Joint> joints = joints_;
  std::vector<int> above(nodes_.size(), -1);  // the joint that a node is or hangs on
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const int parent = nodes_[i].parent ? above[*nodes_[i].parent] : -1;
    const auto found = number_of_.find(nodes_[i].number);
    above[i] = found == number_of_.end() ? parent : found->second;
    if (found != number_of_.end()) joints[found->second].parent = parent;
  }
  return joints;
}

std::optional<std::size_t> GltfRig::joint_of(std::size_t node) const {
  const auto found = number_of_.find(node);
  return found == number_of_.end() ? std::nullopt : std::optional<std::size_t>(found->second);
}

GltfInfluences read_gltf_influences(const GltfFile& file, const nlohmann::json& attributes, std::size_t vertices,
                                    const std::vector<std::uint16_t>& joints) {
  std::vector<std::vector<Influence>> all(vertices);
  for (int set = 0;; ++set) {
    const auto numbers = number_at(file, attributes, fmt::format("JOINTS_{}", set).c_str());
    const auto weights = number_at(file, attributes, fmt::format("WEIGHTS_{}", set).c_str());
    if (!numbers || !weights) break;
    const GltfTable which = read_gltf_table(file, *numbers, {"JOINTS", {4}, vertices});
    const GltfTable weight = read_gltf_table(file, *weights, {"WEIGHTS", {4}, vertices});
    for (std::size_t i = 0; i < vertices; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        if (!(weight.at(i, k) > 0)) continue;
        if (!(which.at(i, k) >= 0 && which.at(i, k) < static_cast<double>(joints.size()))) {
          fail(file, fmt::format("vertex {} of a mesh follows joint {}, which its skin does not have", i, which.at(i, k)));
        }
        all[i].push_back({joints[static_cast<std::size_t>(which.at(i, k))], static_cast<float>(weight.at(i, k))});
      }
    }
  }
  GltfInfluences influences;
  for (const std::vector<Influence>& of_vertex : all) {
    influences.of_vertices.push_back(strongest_influences(of_vertex, Influences{}.size()));
    influences.has_more |= of_vertex.size() > Influences{}.size();
  }
  return influences;
}

}  // namespace homolog
