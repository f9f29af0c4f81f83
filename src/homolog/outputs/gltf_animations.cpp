// SPDX-License-Identifier: MIT
#include "homolog/outputs/gltf_animations.h"

#include <algorithm>

namespace homolog {
namespace {

using nlohmann::ordered_json;

constexpr double least_turn = 1e-6, least_change = 1e-6;

/// An animation as it is written, channel by channel.
struct Channels {
  GltfContent& content;
  const std::vector<double>& times;
  int input = -1;  // the times as written, as soon as a channel needs them
  ordered_json samplers = ordered_json::array(), channels = ordered_json::array();

  void add(std::size_t node, const char* path, const Floats& values, int columns) {
    if (input < 0) input = add_bounded_table(content, Floats(times.begin(), times.end()), 1, GltfTarget::none);
    channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", path}}}});
    samplers.push_back({{"input", input}, {"interpolation", "LINEAR"}, {"output", add_table(content, values, columns, GltfTarget::none)}});
  }
};

void add_poses(Channels& channels, std::size_t node, const Pose& bound, const std::vector<Pose>& poses, double size) {
  Floats shifts, turns, scales;
  bool shifted = false, turned = false, scaled = false;
  for (const Pose& pose : poses) {
    shifted |= (pose.shift - bound.shift).norm() > least_change * size;
    turned |= pose.turn.angularDistance(bound.turn) > least_turn;
    scaled |= (pose.scale - Vec3::Ones()).norm() > least_change;
    for (const double x : pose.shift) shifts.push_back(static_cast<float>(x));
    for (const double x : pose.turn.coeffs()) turns.push_back(static_cast<float>(x));
    for (const double x : pose.scale) scales.push_back(static_cast<float>(x));
  }
  if (shifted) channels.add(node, "translation", shifts, 3);
  if (turned) channels.add(node, "rotation", turns, 4);
  if (scaled) channels.add(node, "scale", scales, 3);
}

void add_weights(Channels& channels, const std::vector<ShapeKey>& keys, const Animation& animation) {
  Floats weights;
  bool moves = false;
  for (std::size_t t = 0; t < animation.times.size(); ++t) {
    for (std::size_t k = 0; k < keys.size(); ++k) {
      weights.push_back(static_cast<float>(animation.weights[k][t]));
      moves |= animation.weights[k][t] != keys[k].weight;
    }
  }
  if (moves) channels.add(0, "weights", weights, 1);
}

/// The extent of the rig, beside which shifts are small or not.
double size_of(const Rig& rig) {
  double size = 0;
  for (const Joint& joint : rig.joints) size = std::max(size, joint.bind.topRightCorner<3, 1>().norm());
  return size;
}

}  // namespace

ordered_json gltf_animations(const AttributedMesh& mesh, std::size_t first_joint, GltfContent& content) {
  ordered_json written;
  for (const Animation& animation : mesh.animations) {
    Channels channels{content, animation.times};
    for (std::size_t i = 0; i < mesh.rig.joints.size(); ++i) {
      add_poses(channels, first_joint + i, pose_of(local_bind(mesh.rig, i)), animation.poses[i], size_of(mesh.rig));
    }
    add_weights(channels, mesh.shape_keys, animation);
    if (channels.channels.empty()) continue;
    written.push_back({{"name", animation.name}, {"samplers", channels.samplers}, {"channels", channels.channels}});
  }
  return written;
}

}  // namespace homolog
