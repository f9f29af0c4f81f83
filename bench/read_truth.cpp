// SPDX-License-Identifier: MIT
// Looked for in this order: vertex numbers (identity group, part of a whole, corr file), then landmarks.
#include "read_truth.h"

#include <algorithm>
#include <set>

#include "homolog/shape/read_mesh.h"
#include "mirror_symmetry.h"
#include "surface_distance.h"
#include "truth_files.h"

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

// The identity group of a mesh; a mesh without one is alone in its own.
IdentityGroup group_of(const fs::path& set, const std::string& name, std::size_t vertices) {
  for (const IdentityGroup& group : read_identity_groups(set)) {
    if (is_in(group, name)) return group;
  }
  return {{name}, vertices};
}

// Vertex numbers (model, data) that correspond.
std::vector<std::pair<int, int>> same_numbers(std::size_t count) {
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0; i < static_cast<int>(count); ++i) pairs.emplace_back(i, i);
  return pairs;
}

std::vector<std::pair<int, int>> vertex_pairs(const fs::path& model_set, const std::string& model, const fs::path& data_set,
                                              const std::string& data, const IdentityGroup& group) {
  if (model_set == data_set && is_in(group, model) && model != data) return same_numbers(group.vertices);
  for (const std::string& name : group.names) {
    const fs::path file = model_set / (model + "__" + name + ".corr.txt");
    if (fs::exists(file)) return read_vertex_pairs(file);
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
    points.model.push_back(model.vertices.at(static_cast<std::size_t>(a)));
    points.data.push_back(data.vertices.at(static_cast<std::size_t>(b)));
    if (swap.empty()) continue;
    points.swapped_data.push_back(data.vertices.at(static_cast<std::size_t>(swap.at(static_cast<std::size_t>(b)))));
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

std::optional<TruePoints> TruthReader::read(const PairEntry& pair, const Mesh& model, const Mesh& data) {
  const fs::path model_set = (folder_ / pair.model).parent_path(), data_set = (folder_ / pair.data).parent_path();
  const std::string model_name = name_of(pair.model), data_name = name_of(pair.data);
  if (model_set == data_set && model_name.starts_with(data_name + "__") && fs::exists(data_set / (data_name + ".parts.txt"))) {
    return part_in_place(model);
  }
  const IdentityGroup group = group_of(data_set, data_name, data.vertices.size());
  const auto pairs = vertex_pairs(model_set, model_name, data_set, data_name, group);
  if (!pairs.empty()) {
    TruePoints points = dense_truth(pairs, vertex_symmetry(data_set, group.names, group.vertices), model, data);
    const std::string source = source_of(model_name);
    points.mirrored = is_in(group, source) && turns_inside_out(read_mesh(data_set / (source + ".off")), data);
    return points;
  }
  const auto data_landmarks = landmarks_of(data_set, data_set, data_name, data);
  return landmark_truth(landmarks_of(model_set, data_set, model_name, model), data_landmarks,
                        read_swap(data_set / (data_name + ".symmetry.txt"), data_landmarks));
}

// One mesh of an identity group that stands symmetric tells the symmetry of all.
const std::vector<int>& TruthReader::vertex_symmetry(const fs::path& set, const std::vector<std::string>& group, std::size_t count) {
  const std::lock_guard lock(mutex_);
  const auto [place, is_new] = symmetries_.try_emplace((set / group.front()).string());
  for (std::size_t i = 0; is_new && i < group.size() && place->second.empty(); ++i) {
    place->second = mirror_symmetry(read_mesh(set / (group[i] + ".off")).vertices, count);
  }
  return place->second;
}

}  // namespace homolog::bench
