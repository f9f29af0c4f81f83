// SPDX-License-Identifier: MIT
#include "homolog/outputs/attributes_gltf.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <map>

#include "homolog/base/read_file.h"
#include "homolog/outputs/gltf_animations.h"
#include "homolog/outputs/gltf_materials.h"
#include "homolog/outputs/json_text.h"
#include "homolog/shape/srgb.h"
#include "homolog/shape/vertex_normals.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;

/// The vertices as glTF wants them, with one UV each: those of the mesh, then copies of some.
struct Split {
  std::vector<std::uint32_t> vertex_of;  ///< of each, the one of the mesh
  std::vector<std::uint32_t> uv_of;      ///< its UV, or no_uv
  std::vector<Triangle> triangles;
};

Split split_at_seams(const AttributedMesh& mesh) {
  Split split{{}, std::vector<std::uint32_t>(mesh.mesh.vertices.size(), Texturing::no_uv), mesh.mesh.triangles};
  for (std::uint32_t i = 0; i < mesh.mesh.vertices.size(); ++i) split.vertex_of.push_back(i);
  if (mesh.texturing.uvs.empty()) return split;
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> copies;
  for (std::size_t t = 0; t < split.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      std::uint32_t& corner = split.triangles[t][k];
      const std::uint32_t vertex = corner, uv = mesh.texturing.corners[t][k];
      if (split.uv_of[vertex] == uv) continue;
      const bool is_first = split.uv_of[vertex] == Texturing::no_uv;
      const auto [copy, is_new] = copies.try_emplace({vertex, uv}, is_first ? vertex : static_cast<std::uint32_t>(split.vertex_of.size()));
      corner = copy->second;
      if (!is_new) continue;
      if (is_first) {
        split.uv_of[vertex] = uv;
      } else {
        split.vertex_of.push_back(vertex);
        split.uv_of.push_back(uv);
      }
    }
  }
  return split;
}

/// Whether most of the surface shows its inner side.
bool is_inside_out(const Mesh& mesh, const std::vector<Vec3>& normals) {
  double outward = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 normal = (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
    outward += normal.dot(normals[a] + normals[b] + normals[c]);
  }
  return outward < 0;
}

/// What stands for each vertex of the mesh, for each of the split ones.
template <class Value>
std::vector<Value> spread(const std::vector<Value>& values, const Split& split) {
  std::vector<Value> result;
  for (const std::uint32_t vertex : split.vertex_of) result.push_back(values[vertex]);
  return result;
}

Floats normals_of(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles, const Split& split) {
  const Floats normals = unit_normals(positions, triangles);
  Floats result;
  for (const std::size_t vertex : split.vertex_of) result.insert(result.end(), &normals[3 * vertex], &normals[3 * vertex] + 3);
  return result;
}

int add_colours(GltfContent& content, const std::vector<Rgba>& colours) {
  Floats values;
  for (const Rgba& colour : colours) {
    const Rgba linear = linear_of_srgb(colour);
    values.insert(values.end(), linear.begin(), linear.end());
  }
  return add_table(content, values, 4, GltfTarget::vertices);
}

int add_uvs(GltfContent& content, const Texturing& texturing, const Split& split) {
  Floats values;
  for (const std::uint32_t uv : split.uv_of) {
    const Uv place = uv == Texturing::no_uv ? Uv{0, 1} : texturing.uvs[uv];
    values.insert(values.end(), {static_cast<float>(place[0]), static_cast<float>(1 - place[1])});
  }
  return add_table(content, values, 2, GltfTarget::vertices);
}

/// As attributes of the file's own. glTF knows no number that is none: it is 0, and such vertices are not _CARRIED.
void add_fields(GltfContent& content, const std::vector<Field>& fields, const Split& split, ordered_json& attributes) {
  Floats carried(split.vertex_of.size(), 1);
  for (const Field& field : fields) {
    Floats values;
    for (const double value : spread(field.values, split)) {
      if (!std::isfinite(value)) carried[values.size()] = 0;
      values.push_back(std::isfinite(value) ? static_cast<float>(value) : 0);
    }
    attributes["_" + field.name] = add_table(content, values, 1, GltfTarget::vertices);
  }
  attributes["_CARRIED"] = add_table(content, carried, 1, GltfTarget::vertices);
}

/// Four influences of every vertex, from the first-th on.
void add_set(GltfContent& content, const std::vector<Influences>& influences, std::size_t first, ordered_json& attributes) {
  std::vector<std::uint16_t> joints;
  Floats weights;
  for (const Influences& of_vertex : influences) {
    const bool follows_none = of_vertex[0].weight == 0;  // then the first joint, for glTF knows no vertex without one
    for (std::size_t k = first; k < first + few_influences; ++k) {
      joints.push_back(of_vertex[k].joint);
      weights.push_back(follows_none && k == 0 ? 1 : of_vertex[k].weight);
    }
  }
  attributes[fmt::format("JOINTS_{}", first / few_influences)] = add_table(content, joints, 4, GltfTarget::vertices);
  attributes[fmt::format("WEIGHTS_{}", first / few_influences)] = add_table(content, weights, 4, GltfTarget::vertices);
}

void add_influences(GltfContent& content, const std::vector<Influences>& influences, ordered_json& attributes) {
  const std::size_t most = most_influences(influences);
  for (std::size_t first = 0; first < most; first += few_influences) add_set(content, influences, first, attributes);
}

/// The tables that all primitives share.
struct Tables {
  ordered_json attributes = ordered_json::object(), targets = ordered_json::array();
};

/// The vertices without any shape key: as the keys' weights are applied to them, they then are as the mesh has them.
std::vector<Vec3> vertices_without_keys(const AttributedMesh& mesh) {
  std::vector<Vec3> vertices = mesh.mesh.vertices;
  for (const ShapeKey& key : mesh.shape_keys) {
    for (std::size_t i = 0; i < vertices.size() && key.weight != 0; ++i) vertices[i] -= key.weight * key.displacements[i];
  }
  return vertices;
}

Tables add_tables(GltfContent& content, const AttributedMesh& mesh, const std::vector<Triangle>& triangles, const Split& split,
                  const Vec3& origin) {
  Tables tables;
  const std::vector<Vec3> vertices = vertices_without_keys(mesh);
  const Floats positions = floats_of(spread(vertices, split), origin), normals = normals_of(vertices, triangles, split);
  tables.attributes["POSITION"] = add_bounded_table(content, positions, 3, GltfTarget::vertices);
  tables.attributes["NORMAL"] = add_table(content, normals, 3, GltfTarget::vertices);
  if (!mesh.colours.empty()) tables.attributes["COLOR_0"] = add_colours(content, spread(mesh.colours, split));
  if (!mesh.texturing.uvs.empty()) tables.attributes["TEXCOORD_0"] = add_uvs(content, mesh.texturing, split);
  if (!mesh.fields.empty()) add_fields(content, mesh.fields, split, tables.attributes);
  if (!mesh.rig.joints.empty()) add_influences(content, spread(mesh.rig.influences, split), tables.attributes);
  for (const ShapeKey& key : mesh.shape_keys) {
    std::vector<Vec3> moved = vertices;
    for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += key.displacements[i];
    const Floats displacements = floats_of(spread(key.displacements, split));
    tables.targets.push_back(
        {{"POSITION", add_bounded_table(content, displacements, 3, GltfTarget::vertices)},
         {"NORMAL", add_table(content, difference(normals_of(moved, triangles, split), normals), 3, GltfTarget::vertices)}});
  }
  return tables;
}

ordered_json primitives_of(GltfContent& content, const AttributedMesh& mesh, const Split& split, const Tables& tables, bool inside_out) {
  std::map<int, std::vector<std::uint32_t>> corners;  // of every material
  for (std::size_t t = 0; t < split.triangles.size(); ++t) {
    const auto& [a, b, c] = split.triangles[t];
    const int material = mesh.texturing.materials.empty() ? -1 : mesh.texturing.material_of[t];
    corners[material].insert(corners[material].end(), {a, inside_out ? c : b, inside_out ? b : c});
  }
  ordered_json primitives = ordered_json::array();
  for (const auto& [material, numbers] : corners) {
    ordered_json primitive = {{"attributes", tables.attributes}, {"indices", add_table(content, numbers, 1, GltfTarget::triangles)}};
    if (material >= 0) primitive["material"] = material;
    if (!tables.targets.empty()) primitive["targets"] = tables.targets;
    primitives.push_back(primitive);
  }
  return primitives;
}

ordered_json mesh_of(const AttributedMesh& mesh, const ordered_json& primitives, const std::string& name) {
  ordered_json result = {{"name", name}, {"primitives", primitives}};
  if (mesh.shape_keys.empty()) return result;
  ordered_json names = ordered_json::array(), weights = ordered_json::array();
  for (const ShapeKey& key : mesh.shape_keys) {
    names.push_back(key.name);
    weights.push_back(key.weight);
  }
  result["weights"] = weights;
  result["extras"] = {{"targetNames", names}};
  return result;
}

constexpr std::size_t first_joint = 2;  // of the nodes

/// Nodes 0, the mesh, 1, above the joints, and the joints; and the skin.
void add_rig(ordered_json& json, const Rig& rig, GltfContent& content) {
  ordered_json& nodes = json["nodes"];
  nodes[0]["skin"] = 0;
  nodes.push_back({{"name", "rig"}, {"children", ordered_json::array()}});
  Floats inverses;
  ordered_json joints = ordered_json::array();
  for (const Joint& joint : rig.joints) {
    const Mat4 inverse = joint.bind.inverse(), local = local_bind(rig, joints.size());
    for (Eigen::Index i = 0; i < 16; ++i) inverses.push_back(static_cast<float>(inverse.data()[i]));
    for (Eigen::Index column = 0; column < 4; ++column) inverses[inverses.size() - 13 + 4 * column] = column == 3 ? 1 : 0;  // exactly
    const Eigen::Quaterniond turn = Eigen::Quaterniond(Mat3(local.topLeftCorner<3, 3>())).normalized();
    joints.push_back(nodes.size());
    nodes.push_back({{"name", joint.name},
                     {"translation", {local(0, 3), local(1, 3), local(2, 3)}},
                     {"rotation", {turn.x(), turn.y(), turn.z(), turn.w()}}});
  }
  for (std::size_t i = 0; i < rig.joints.size(); ++i) {
    const int parent = rig.joints[i].parent;
    nodes[parent < 0 ? 1 : static_cast<std::size_t>(parent) + first_joint]["children"].push_back(i + first_joint);
  }
  json["skins"] = {{{"inverseBindMatrices", add_table(content, inverses, 16, GltfTarget::none)}, {"joints", joints}, {"skeleton", 1}}};
  json["scenes"][0]["nodes"].push_back(1);
}

}  // namespace

std::vector<OutputFile> attributes_gltf(const AttributedMesh& mesh, const std::filesystem::path& out, const std::string& from,
                                        const std::string& name) {
  // A skinned mesh stands where its joints say, so that its node cannot move it.
  const Box box = bounding_box(mesh.mesh);
  const Vec3 origin = mesh.rig.joints.empty() ? Vec3((box.min + box.max) / 2) : Vec3::Zero();
  const bool inside_out = is_inside_out(mesh.mesh, vertex_normals(mesh.mesh));
  std::vector<Triangle> triangles = mesh.mesh.triangles;
  if (inside_out) turn_over(triangles);
  GltfContent content;
  const Split split = split_at_seams(mesh);
  const Tables tables = add_tables(content, mesh, triangles, split, origin);
  const std::string stem = out.stem().string(), told = name.empty() ? stem : name;
  ordered_json json = {{"scene", 0},
                       {"scenes", {{{"nodes", {0}}}}},
                       {"nodes", {{{"name", told}, {"mesh", 0}}}},
                       {"meshes", {mesh_of(mesh, primitives_of(content, mesh, split, tables, inside_out), told)}}};
  if (!origin.isZero()) json["nodes"][0]["translation"] = {origin.x(), origin.y(), origin.z()};
  if (!mesh.rig.joints.empty()) add_rig(json, mesh.rig, content);
  json.update(gltf_materials(mesh.texturing, content));
  const ordered_json animations = gltf_animations(mesh, first_joint, content);
  if (!animations.is_null()) json["animations"] = animations;
  json["extras"] = {{"carried_from", from}};
  if (lower_extension(out) == ".glb") return {{out, glb_bytes(gltf_document(json, content), content)}};
  const std::filesystem::path bin = out.parent_path() / (stem + ".bin");
  const std::string document = json_dump(gltf_document(json, content, uri_of_name(bin.filename().string())), 2);
  return {{out, document}, {bin, content.bytes}};
}

std::vector<std::string> pictures_left_out(const Texturing& texturing) {
  std::vector<std::string> names;
  for (const Image& image : texturing.images) {
    if (texturing.gltf.empty() && picture_type(image.bytes).empty()) names.push_back(image.name);
  }
  return names;
}

}  // namespace homolog
