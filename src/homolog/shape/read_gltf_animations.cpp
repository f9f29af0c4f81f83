// SPDX-License-Identifier: MIT
#include "homolog/shape/read_gltf_animations.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>

#include "homolog/shape/gltf_curves.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

using nlohmann::json;

constexpr std::size_t most_poses = 5'000'000, most_times = 1'000'000;

/// Whether a node is a joint or has one below it.
std::vector<char> bear_joints(const GltfActors& actors) {
  std::vector<char> bear(actors.nodes.size(), false);
  for (std::size_t i = bear.size(); i-- > 0;) {
    if (actors.rig.joint_of(actors.nodes[i].number)) bear[i] = true;
    if (bear[i] && actors.nodes[i].parent) bear[*actors.nodes[i].parent] = true;
  }
  return bear;
}

/// The channels that move joints or shape keys.
std::vector<GltfChannel> moving_channels(const GltfFile& file, const GltfActors& actors, const json& animation) {
  const std::vector<char> bear = bear_joints(actors);
  std::vector<GltfChannel> channels;
  for (GltfChannel& channel : read_gltf_channels(file, animation)) {
    const auto targets = actors.targets.find(channel.node);
    const auto node = std::find_if(actors.nodes.begin(), actors.nodes.end(), [&](const GltfNode& n) { return n.number == channel.node; });
    const bool moves_keys = channel.path == GltfPath::weights && targets != actors.targets.end();
    if (moves_keys && channel.curve.width != targets->second.size()) fail(file, "an animation has not one weight for each target");
    const bool moves_joints = channel.path != GltfPath::weights && node != actors.nodes.end() && bear[node - actors.nodes.begin()];
    if (moves_keys || moves_joints) channels.push_back(std::move(channel));
  }
  return channels;
}

void move(Pose& pose, GltfPath path, const std::vector<double>& values) {
  if (path == GltfPath::translation) pose.shift = Eigen::Map<const Vec3>(values.data());
  if (path == GltfPath::scale) pose.scale = Eigen::Map<const Vec3>(values.data());
  if (path != GltfPath::rotation) return;
  const Eigen::Quaterniond turn(values[3], values[0], values[1], values[2]);
  pose.turn = turn.squaredNorm() > 0 ? turn.normalized() : Eigen::Quaterniond::Identity();
}

/// Poses of nodes, by their numbers.
using Poses = std::map<std::size_t, Pose>;

/// What the document says of the nodes that move.
Poses poses_at_rest(const GltfFile& file, const std::vector<GltfChannel>& channels) {
  Poses poses;
  for (const GltfChannel& channel : channels) {
    if (channel.path != GltfPath::weights) poses[channel.node] = stated_pose(file, entry(file, "nodes", channel.node));
  }
  return poses;
}

/// The frames of all nodes at a time.
std::vector<Mat4> worlds_at(const GltfActors& actors, Poses poses, const std::vector<GltfChannel>& channels, double time) {
  for (const GltfChannel& channel : channels) {
    if (channel.path != GltfPath::weights) move(poses.at(channel.node), channel.path, values_at(channel.curve, time));
  }
  std::vector<Mat4> worlds;
  for (const GltfNode& node : actors.nodes) {
    const auto moved = poses.find(node.number);
    const Mat4 local = moved == poses.end() ? node.local : matrix_of(moved->second);
    worlds.push_back(node.parent ? Mat4(worlds[*node.parent] * local) : local);
  }
  return worlds;
}

/// Appends where every joint stands in its parent.
void append_poses(const GltfActors& actors, const std::vector<Joint>& joints, const std::vector<Mat4>& worlds, Animation& animation) {
  std::vector<Mat4> frames;
  for (const Joint& joint : joints) frames.push_back(joint.bind);  // for those outside the scene
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    if (const auto joint = actors.rig.joint_of(actors.nodes[i].number)) frames[*joint] = worlds[i];
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Mat4 local = joints[i].parent < 0 ? frames[i] : Mat4(frames[joints[i].parent].inverse() * frames[i]);
    std::vector<Pose>& poses = animation.poses[i];
    Pose pose = local.allFinite() ? pose_of(local) : poses.empty() ? Pose{} : poses.back();  // nothing stands in what has no size
    if (!poses.empty() && poses.back().turn.dot(pose.turn) < 0) pose.turn.coeffs() = -pose.turn.coeffs();
    poses.push_back(pose);
  }
}

void append_weights(const GltfActors& actors, const std::vector<GltfChannel>& channels, double time, Animation& animation) {
  for (std::size_t k = 0; k < actors.keys.size(); ++k) animation.weights[k].push_back(actors.keys[k].weight);
  for (const GltfChannel& channel : channels) {
    if (channel.path != GltfPath::weights) continue;
    const std::vector<double> values = values_at(channel.curve, time);
    const std::vector<std::size_t>& keys = actors.targets.at(channel.node);
    for (std::size_t k = 0; k < keys.size(); ++k) animation.weights[keys[k]].back() = values[k];
  }
}

/// Fills the last animation.
void append_course(const GltfFile& file, const GltfActors& actors, const std::vector<GltfChannel>& channels, AttributedMesh& mesh) {
  Animation& animation = mesh.animations.back();
  animation.poses.resize(mesh.rig.joints.size());
  animation.weights.resize(actors.keys.size());
  const Poses at_rest = poses_at_rest(file, channels);
  for (const double time : animation.times) {
    append_poses(actors, mesh.rig.joints, worlds_at(actors, at_rest, channels, time), animation);
    append_weights(actors, channels, time, animation);
  }
}

}  // namespace

void read_gltf_animations(const GltfFile& file, const GltfActors& actors, AttributedMesh& mesh) {
  const auto list = file.document.find("animations");
  if (list == file.document.end() || !list->is_array()) return;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string stated = text_at((*list)[i], "name"), name = stated.empty() ? fmt::format("animation {}", i + 1) : stated;
    const std::vector<GltfChannel> channels = moving_channels(file, actors, (*list)[i]);
    const std::vector<double> times = times_of(channels, most_times);
    if (channels.empty()) {
      mesh.left_out.push_back(fmt::format("'{}', an animation of neither joints nor shape keys", shown(name)));
    } else if (times.size() > most_times || times.size() * (actors.nodes.size() + actors.keys.size()) > most_poses) {
      mesh.left_out.push_back(fmt::format("'{}', an animation of more than {} poses", shown(name), most_poses));
    } else {
      mesh.animations.push_back({name, times, {}, {}});
      append_course(file, actors, channels, mesh);
    }
  }
}

}  // namespace homolog
