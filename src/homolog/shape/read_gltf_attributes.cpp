// SPDX-License-Identifier: MIT
#include "homolog/shape/read_gltf_attributes.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "homolog/base/errors.h"
#include "homolog/shape/gltf_instance.h"
#include "homolog/shape/read_gltf_animations.h"
#include "homolog/shape/read_gltf_materials.h"
#include "homolog/shape/srgb.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

using nlohmann::json;

constexpr std::size_t most_displacements = 50'000'000;
constexpr std::size_t most_values = 50'000'000;
constexpr int gltf_float = 5126;  // glTF's component type

struct Reader {
  const GltfFile& file;
  GltfRig rig;
  std::size_t most_triangles;
  AttributedMesh mesh;
  TargetsOfNodes targets = {};
  bool has_colours = false, has_weaker_weights = false;
};

/// Vertices that primitives of a mesh share, because they name the same tables.
struct Block {
  const json &attributes, &targets;
  std::size_t vertices;
  std::uint32_t first;                    ///< of the vertices
  std::optional<std::uint32_t> first_uv;  ///< none: they have no UVs
};

/// A mesh of the file as a node shows it.
struct Instance {
  GltfInstance shown;
  std::vector<Block> blocks;
};

void append_colours(Reader& reader, const json& attributes, std::size_t vertices) {
  const auto number = number_at(reader.file, attributes, "COLOR_0");
  reader.mesh.colours.resize(reader.mesh.colours.size() + vertices, Rgba{1, 1, 1, 1});
  if (!number) return;
  reader.has_colours = true;
  const GltfTable colours = read_gltf_table(reader.file, *number, {"COLOR_0", {3, 4}, vertices});
  for (std::size_t i = 0; i < vertices; ++i) {
    Rgba& colour = reader.mesh.colours[reader.mesh.colours.size() - vertices + i];
    for (std::size_t k = 0; k < colours.columns; ++k) colour[k] = static_cast<float>(colours.at(i, k));
    colour = srgb_of_linear(colour);
  }
}

/// The one of that name; `otherwise` is added if there is none.
template <class Named>
Named& of_name(std::vector<Named>& list, Named otherwise) {
  for (Named& named : list) {
    if (named.name == otherwise.name) return named;
  }
  return list.emplace_back(std::move(otherwise));
}

/// Told once, however many meshes have it.
void leave_out(AttributedMesh& mesh, std::string what) {
  auto& left_out = mesh.left_out;
  if (std::find(left_out.begin(), left_out.end(), what) == left_out.end()) left_out.push_back(std::move(what));
}

/// Attributes of the file's own, whose names begin with '_': those of one number are fields, labels if the numbers are whole by type.
void append_fields(Reader& reader, const json& attributes, std::size_t first, std::size_t vertices) {
  AttributedMesh& mesh = reader.mesh;
  for (const auto& [name, value] : attributes.items()) {
    if (name == "TEXCOORD_1") leave_out(mesh, "a second set of UVs");
    if (name == "COLOR_1") leave_out(mesh, "a second set of colours");
    if (!name.starts_with('_')) continue;
    const std::size_t number = *number_at(reader.file, attributes, name.c_str());
    const json& accessor = entry(reader.file, "accessors", number);
    if (!accessor.contains("type") || accessor["type"] != "SCALAR") {
      leave_out(mesh, fmt::format("the attribute {}, which has several numbers", shown(name)));
      continue;
    }
    const bool is_whole = accessor.contains("componentType") && accessor["componentType"] != gltf_float;
    Field& field = of_name(mesh.fields, Field{name.substr(1), is_whole ? Field::Kind::label : Field::Kind::value, {}});
    if (mesh.fields.size() * (first + vertices) > most_values) {
      throw FileError(
          fmt::format("{}: its vertices hold more than the {} values that are read; leave some out", reader.file.name, most_values));
    }
    field.values.resize(first, std::numeric_limits<double>::quiet_NaN());
    const GltfTable table = read_gltf_table(reader.file, number, {"an attribute's table", {1}, vertices});
    field.values.insert(field.values.end(), table.values.begin(), table.values.end());
  }
}

std::optional<std::uint32_t> append_uvs(Reader& reader, const json& attributes, std::size_t vertices) {
  const auto number = number_at(reader.file, attributes, "TEXCOORD_0");
  if (!number) return {};
  std::vector<Uv>& uvs = reader.mesh.texturing.uvs;
  const auto first = static_cast<std::uint32_t>(uvs.size());
  const GltfTable table = read_gltf_table(reader.file, *number, {"TEXCOORD_0", {2}, vertices});
  for (std::size_t i = 0; i < vertices; ++i) uvs.push_back({table.at(i, 0), 1 - table.at(i, 1)});
  return first;
}

/// The UVs and the material of the triangles that a primitive added.
void append_texturing(Reader& reader, const json& primitive, const Block& block) {
  Texturing& texturing = reader.mesh.texturing;
  const auto material = number_at(reader.file, primitive, "material");
  if (material && *material >= texturing.materials.size()) fail(reader.file, fmt::format("material {} does not exist", *material));
  for (std::size_t t = texturing.corners.size(); t < reader.mesh.mesh.triangles.size(); ++t) {
    texturing.corners.push_back({Texturing::no_uv, Texturing::no_uv, Texturing::no_uv});
    for (int k = 0; k < 3 && block.first_uv; ++k) {
      texturing.corners.back()[k] = reader.mesh.mesh.triangles[t][k] - block.first + *block.first_uv;
    }
    texturing.material_of.push_back(material ? static_cast<int>(*material) : -1);
  }
}

/// The key of the name that a mesh gives its target, or of a name made of its number.
ShapeKey& key_of(Reader& reader, const GltfInstance& instance, std::size_t target) {
  const json& names = list_at(object_at(instance.mesh, "extras"), "targetNames");
  const bool named = target < names.size() && names[target].is_string();
  const std::string name = named ? names[target].get<std::string>() : fmt::format("key {}", target + 1);
  return of_name(reader.mesh.shape_keys, ShapeKey{name, target < instance.weights.size() ? instance.weights[target] : 0, {}});
}

void append_shape_keys(Reader& reader, const GltfInstance& instance, const json& primitive, std::size_t first, const GltfPlacing& placing,
                       std::size_t vertices) {
  const json& targets = list_at(primitive, "targets");
  for (std::size_t k = 0; k < targets.size(); ++k) {
    ShapeKey& key = key_of(reader, instance, k);
    std::vector<std::size_t>& of_node = reader.targets[instance.node];
    if (of_node.size() == k) of_node.push_back(static_cast<std::size_t>(&key - reader.mesh.shape_keys.data()));
    if (reader.mesh.shape_keys.size() * (first + vertices) > most_displacements) {
      throw FileError(fmt::format("{}: its shape keys hold more than the {} displacements that are read; leave some out", reader.file.name,
                                  most_displacements));
    }
    key.displacements.resize(first + vertices, Vec3::Zero());
    const auto table = target_of(reader.file, targets[k], vertices);
    for (std::size_t i = 0; table && i < vertices; ++i) {
      key.displacements[first + i] = placing.at(i).topLeftCorner<3, 3>() * table->vec3(i);
    }
  }
}

void append_influences(Reader& reader, const GltfPlacing& placing, std::size_t vertices) {
  auto& influences = reader.mesh.rig.influences;
  influences.insert(influences.end(), placing.influences.begin(), placing.influences.end());
  influences.resize(influences.size() + vertices - placing.influences.size());
  reader.has_weaker_weights |= placing.has_weaker_weights;
}

/// The vertices of a primitive, with what is said of them; those of an earlier one if it names the same tables.
Block block_of(Reader& reader, Instance& instance, const json& primitive) {
  const json &attributes = object_at(primitive, "attributes"), &targets = list_at(primitive, "targets");
  for (const Block& block : instance.blocks) {
    if (block.attributes == attributes && block.targets == targets) return block;
  }
  const GltfTable positions = positions_of(reader.file, primitive, reader.most_triangles);
  const std::size_t first = reader.mesh.mesh.vertices.size(), vertices = positions.rows;
  check_count(reader.file, reader.mesh.mesh.triangles.size(), first + vertices, reader.most_triangles);
  const GltfPlacing placing = placing_of(reader.file, instance.shown, primitive, vertices);
  const std::vector<Vec3> placed = placed_vertices(reader.file, instance.shown, primitive, positions, placing);
  reader.mesh.mesh.vertices.insert(reader.mesh.mesh.vertices.end(), placed.begin(), placed.end());
  append_colours(reader, attributes, vertices);
  append_shape_keys(reader, instance.shown, primitive, first, placing, vertices);
  append_influences(reader, placing, vertices);
  append_fields(reader, attributes, first, vertices);
  const auto first_uv = append_uvs(reader, attributes, vertices);
  instance.blocks.push_back({attributes, targets, vertices, static_cast<std::uint32_t>(first), first_uv});
  return instance.blocks.back();
}

void append_primitive(Reader& reader, Instance& instance, const json& primitive) {
  if (!draws_triangles(reader.file, primitive)) return;
  const Block block = block_of(reader, instance, primitive);
  Mesh& mesh = reader.mesh.mesh;
  const auto triangles = triangles_of(reader.file, primitive, block.vertices, block.first);
  mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
  check_count(reader.file, mesh.triangles.size(), mesh.vertices.size(), reader.most_triangles);
  append_texturing(reader, primitive, block);
}

void append_nodes(Reader& reader, const std::vector<GltfNode>& nodes) {
  for (const GltfNode& node : nodes) {
    auto shown = instance_of(reader.file, node, reader.rig);
    if (!shown) continue;
    Instance instance{std::move(*shown), {}};
    for (const json& primitive : list_at(instance.shown.mesh, "primitives")) append_primitive(reader, instance, primitive);
  }
}

/// Fills in what only some meshes have, and takes off what none has.
void complete(Reader& reader) {
  AttributedMesh& mesh = reader.mesh;
  if (!reader.has_colours) mesh.colours.clear();
  for (ShapeKey& key : mesh.shape_keys) key.displacements.resize(mesh.mesh.vertices.size(), Vec3::Zero());
  for (Field& field : mesh.fields) field.values.resize(mesh.mesh.vertices.size(), std::numeric_limits<double>::quiet_NaN());
  mesh.rig.joints = reader.rig.joints();
  if (mesh.rig.joints.empty()) mesh.rig.influences.clear();
  if (reader.has_weaker_weights) mesh.left_out.emplace_back("all but the strongest eight weights of a vertex");
  if (mesh.texturing.uvs.empty() && mesh.texturing.materials.empty()) mesh.texturing = {};
}

}  // namespace

AttributedMesh read_gltf_attributes(std::string_view content, const std::string& file, const FindOther& find_other,
                                    std::size_t most_triangles) {
  const GltfFile gltf = read_gltf_file(content, file, find_other);
  const std::vector<GltfNode> nodes = scene_nodes(gltf);
  Reader reader{gltf, {gltf, nodes}, most_triangles, {}};
  read_gltf_materials(gltf, find_other, reader.mesh);
  append_nodes(reader, nodes);
  complete(reader);
  read_gltf_animations(gltf, {nodes, reader.rig, reader.mesh.shape_keys, reader.targets}, reader.mesh);
  return std::move(reader.mesh);
}

}  // namespace homolog
