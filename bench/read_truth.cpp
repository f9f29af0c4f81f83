// SPDX-License-Identifier: MIT
// Looked for in this order: vertex numbers (identity group, part of a whole, corr file), then landmarks.
#include "read_truth.h"

#include <fmt/format.h>

#include <algorithm>

#include "homolog/shape/read_mesh.h"
#include "homolog/shape/text.h"
#include "mirror_symmetry.h"
#include "surface_distance.h"

namespace homolog::bench {
namespace {

namespace fs = std::filesystem;

constexpr double in_part = 0.02;  // landmarks are clicked to about 2 % of the diagonal

std::string name_of(const std::string& model) { return fs::path(model).filename().string(); }

// What a part SOURCE__PART was cut from; a whole is its own source.
std::string source_of(const std::string& name) { return name.substr(0, name.find("__")); }

bool is_in(const IdentityGroup& group, const std::string& name) {
  return std::find(group.names.begin(), group.names.end(), name) != group.names.end();
}

// One mesh of a pair, with the folder where its files lie.
struct Member {
  fs::path set;
  std::string name;
  const Mesh& mesh;
};

[[noreturn]] void fail_in(const fs::path& set, const IdentityGroup& group, const std::string& what) {
  fail(Text{(set / "IDENTITY.corr.txt").string(), {}, group.line}, what);
}

void check_count(const Member& member, const IdentityGroup& group) {
  const std::size_t count = member.mesh.vertices.size();
  if (count >= group.vertices) return;
  fail_in(member.set, group, fmt::format("{} has {} vertices, not {}", member.name, count, group.vertices));
}

// The identity group of a mesh; a mesh without one is alone in its own.
IdentityGroup group_of(const Member& data) {
  for (const IdentityGroup& group : read_identity_groups(data.set)) {
    if (!is_in(group, data.name)) continue;
    check_count(data, group);
    return group;
  }
  return {{data.name}, data.mesh.vertices.size()};
}

// Vertex numbers (model, data) that correspond.
std::vector<std::pair<int, int>> same_numbers(std::size_t count) {
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0; i < static_cast<int>(count); ++i) pairs.emplace_back(i, i);
  return pairs;
}

std::vector<std::pair<int, int>> vertex_pairs(const Member& model, const Member& data, const IdentityGroup& group) {
  if (model.set == data.set && is_in(group, model.name) && model.name != data.name) {
    check_count(model, group);
    return same_numbers(group.vertices);
  }
  for (const std::string& name : group.names) {
    const fs::path file = model.set / (model.name + "__" + name + ".corr.txt");
    if (fs::exists(file)) return read_vertex_pairs(file, model.mesh.vertices.size(), group.vertices);
  }
  return {};
}

// Six times the volume of a closed mesh, and of its triangles about the vertices of another.
double volume(const Mesh& mesh, const std::vector<Vec3>& vertices) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) sum += vertices[a].cross(vertices[b]).dot(vertices[c]);
  return sum;
}

// Is the data a mirror image? Then the triangles of the whole that the model is or was cut from, outward as they are, turn inside
// out when its vertices go where the data has them.
bool turns_inside_out(const Mesh& whole, const Mesh& data) {
  return whole.vertices.size() <= data.vertices.size() && volume(whole, whole.vertices) * volume(whole, data.vertices) < 0;
}

TruePoints dense_truth(const std::vector<std::pair<int, int>>& pairs, const std::vector<int>& swap, const Mesh& model, const Mesh& data) {
  TruePoints points;
  for (const auto& [a, b] : pairs) {
    points.model.push_back(model.vertices[static_cast<std::size_t>(a)]);
    points.data.push_back(data.vertices[static_cast<std::size_t>(b)]);
    if (swap.empty()) continue;
    points.swapped_data.push_back(data.vertices[static_cast<std::size_t>(swap[static_cast<std::size_t>(b)])]);
  }
  return points;
}

// A part that lies in its whole: every place is its own truth, and the other side of z = 0 the swapped one.
TruePoints part_in_place(const Mesh& part) {
  TruePoints points;
  points.model = points.data = points.swapped_data = part.vertices;
  for (Vec3& p : points.swapped_data) p.z() = -p.z();
  return points;
}

// The landmarks of a mesh, or those of its source that lie in a part of it (SOURCE__PART).
std::vector<Landmark> landmarks_of(const fs::path& set, const fs::path& other_set, const std::string& name, const Mesh& mesh) {
  const std::string source = source_of(name);
  std::vector<Landmark> landmarks = read_landmarks(set / (source + ".landmarks.txt"));
  if (landmarks.empty()) landmarks = read_landmarks(other_set / (source + ".landmarks.txt"));
  if (source == name) return landmarks;
  const double far = in_part * bounding_box(mesh).diagonal();
  std::erase_if(landmarks, [&](const Landmark& l) { return surface_distance(mesh, l.position) > far; });
  return landmarks;
}

std::optional<TruePoints> landmark_truth(const std::vector<Landmark>& model, const std::vector<Landmark>& data,
                                         const std::vector<std::size_t>& swap) {
  TruePoints points;
  points.dense = false;
  for (const Landmark& m : model) {
    const auto found = std::find_if(data.begin(), data.end(), [&](const Landmark& d) { return d.name == m.name; });
    if (found == data.end()) continue;
    points.model.push_back(m.position);
    points.data.push_back(found->position);
    if (!swap.empty()) points.swapped_data.push_back(data[swap[static_cast<std::size_t>(found - data.begin())]].position);
  }
  if (points.model.size() < 4) return std::nullopt;
  const auto loss = [&](bool mirrored) { return residual(fit_similarity(points.model, points.data, mirrored), points.model, points.data); };
  points.mirrored = loss(true) < 0.5 * loss(false);
  return points;
}

}  // namespace

TruthReader::TruthReader(fs::path folder) : folder_(std::move(folder)) {}

std::optional<TruePoints> TruthReader::read(const PairEntry& pair, const Mesh& model_mesh, const Mesh& data_mesh) {
  const Member model{(folder_ / pair.model).parent_path(), name_of(pair.model), model_mesh};
  const Member data{(folder_ / pair.data).parent_path(), name_of(pair.data), data_mesh};
  if (model.set == data.set && model.name.starts_with(data.name + "__") && fs::exists(data.set / (data.name + ".parts.txt"))) {
    return part_in_place(model.mesh);
  }
  const IdentityGroup group = group_of(data);
  const auto pairs = vertex_pairs(model, data, group);
  if (!pairs.empty()) {
    TruePoints points = dense_truth(pairs, vertex_symmetry(data.set, group), model.mesh, data.mesh);
    const std::string source = source_of(model.name);
    points.mirrored = is_in(group, source) && turns_inside_out(read_mesh(data.set / (source + ".off")), data.mesh);
    return points;
  }
  const auto data_landmarks = landmarks_of(data.set, data.set, data.name, data.mesh);
  return landmark_truth(landmarks_of(model.set, data.set, model.name, model.mesh), data_landmarks,
                        read_swap(data.set / (data.name + ".symmetry.txt"), data_landmarks));
}

// One mesh of an identity group that stands symmetric tells the symmetry of all; a folder may hold but some of them. What cannot be read is
// not remembered as without one.
const std::vector<int>& TruthReader::vertex_symmetry(const fs::path& set, const IdentityGroup& group) {
  const std::lock_guard lock(mutex_);
  const std::string key = (set / group.names.front()).string();
  if (const auto known = symmetries_.find(key); known != symmetries_.end()) return known->second;
  std::vector<int> swap;
  for (std::size_t i = 0; i < group.names.size() && swap.empty(); ++i) {
    const fs::path file = set / (group.names[i] + ".off");
    if (!fs::exists(file)) continue;
    const Mesh mesh = read_mesh(file);
    check_count({set, group.names[i], mesh}, group);
    swap = mirror_symmetry(mesh.vertices, group.vertices);
  }
  return symmetries_.emplace(key, std::move(swap)).first->second;
}

}  // namespace homolog::bench
