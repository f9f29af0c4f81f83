// SPDX-License-Identifier: MIT
#include "homolog/shape/read_gltf_rig.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "homolog/shape/gltf_table.h"

namespace homolog {
namespace {

constexpr double least_scale = 1e-30, single_precision = 1e-5;  // of what a chain of nodes in single precision leaves

/// The inverse bind matrices of a skin, one for each joint.
std::vector<Mat4> inverses_of(const GltfFile& file, const nlohmann::json& skin, std::size_t number, std::size_t joints) {
  const auto table = number_at(file, skin, "inverseBindMatrices");
  if (!table) return std::vector<Mat4>(joints, Mat4::Identity());
  const GltfTable matrices = read_gltf_table(file, *table, {"inverse bind matrices", {16}, {}});
  if (matrices.rows < joints) fail(file, fmt::format("skin {} has fewer inverse bind matrices than joints", number));
  std::vector<Mat4> inverses;
  for (std::size_t i = 0; i < joints; ++i) {
    inverses.emplace_back(Eigen::Map<const Mat4>(matrices.values.data() + 16 * i));
    inverses.back().row(3) = Eigen::RowVector4d::Unit(3);
    if (!inverses.back().inverse().allFinite()) {
      fail(file, fmt::format("joint {} of skin {} has a bind matrix without inverse", i, number));
    }
  }
  return inverses;
}

/// A frame with an inverse: axes that a node draws to nothing, as it hides a thing, are as long as they were.
Mat4 with_all_axes(const Mat4& frame) {
  Pose pose = pose_of(frame);
  if (pose.scale.cwiseAbs().minCoeff() > least_scale && frame.inverse().allFinite()) return frame;
  for (double& scale : pose.scale) scale = std::abs(scale) > least_scale ? scale : 1;
  return matrix_of(pose);
}

/// Whether two matrices take what lies within `reach` of the origin to the same places, as far as single precision tells.
bool is_same_move(const Mat4& a, const Mat4& b, double reach) {
  const double size = a.topLeftCorner<3, 3>().norm();
  return (a - b).topLeftCorner<3, 3>().norm() <= single_precision * size &&
         (a - b).topRightCorner<3, 1>().norm() <= single_precision * (size * reach + a.topRightCorner<3, 1>().norm());
}

/// Leaves out what all joints do alike, so that a mesh at rest stays as it is to the last digit.
void join_equal_moves(GltfSkin& skin, const std::vector<Mat4>& inverses) {
  double reach = 0;
  for (const Mat4& inverse : inverses) reach = std::max(reach, inverse.inverse().topRightCorner<3, 1>().norm());
  const auto as_first = [&](std::uint16_t joint) { return is_same_move(skin.first, skin.of_joints[joint], reach); };
  if (!std::all_of(skin.joints.begin(), skin.joints.end(), as_first)) return;
  skin.of_joints.clear();
  if (is_same_move(Mat4::Identity(), skin.first, reach)) skin.first.setIdentity();
}

}  // namespace

GltfRig::GltfRig(const GltfFile& file, const std::vector<GltfNode>& nodes) : file_(file), nodes_(nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) place_of_[nodes[i].number] = i;
}

/// Where a joint stands; one that the scene does not show stands as it was bound.
Mat4 GltfRig::world_of(std::size_t node, const Mat4& inverse_bind) const {
  const auto found = place_of_.find(node);
  return found == place_of_.end() ? Mat4(inverse_bind.inverse()) : nodes_[found->second].world;
}

std::uint16_t GltfRig::add_joint(std::size_t node, const Mat4& inverse_bind) {
  const auto [found, is_new] = number_of_.try_emplace(node, static_cast<std::uint16_t>(joints_.size()));
  if (!is_new) return found->second;
  const Mat4 world = world_of(node, inverse_bind);
  const Mat4 bind = world.allFinite() ? with_all_axes(world) : world;
  if (!bind.allFinite() || !bind.inverse().allFinite()) fail(file_, fmt::format("node {} does not stand at a finite place", node));
  joints_.push_back({text_at(entry(file_, "nodes", node), "name"), -1, bind});
  if (joints_.size() > std::numeric_limits<std::uint16_t>::max()) fail(file_, "it has more joints than weights can name");
  return found->second;
}

GltfSkin GltfRig::add_skin(std::size_t number) {
  const nlohmann::json& skin = entry(file_, "skins", number);
  const std::vector<std::size_t> nodes = numbers_at(file_, skin, "joints");
  const std::vector<Mat4> inverses = inverses_of(file_, skin, number, nodes.size());
  GltfSkin added;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    added.joints.push_back(add_joint(nodes[i], inverses[i]));
    const Mat4 move = world_of(nodes[i], inverses[i]) * inverses[i];
    if (i == 0) added.first = move;
    added.of_joints.resize(joints_.size(), Mat4::Identity());
    added.of_joints[added.joints.back()] = move;
  }
  join_equal_moves(added, inverses);
  return added;
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
