// SPDX-License-Identifier: MIT
#include "homolog/outputs/morph.h"

#include "homolog/outputs/glb.h"
#include "homolog/shape/orient.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;

int add_colours(GltfContent& content, const std::vector<Colour>& colours) {
  std::vector<std::uint8_t> values;  // four a vertex, so that each begins at a multiple of four bytes
  for (const Colour& colour : colours) values.insert(values.end(), {colour[0], colour[1], colour[2], 255});
  const int accessor = add_table(content, values, 4, GltfTarget::vertices);
  content.accessors.back()["normalized"] = true;
  return accessor;
}

/// The mesh's one primitive.
ordered_json primitive_of(GltfContent& content, const Morph& morph, const Vec3& origin, const std::vector<Colour>& colours) {
  const auto triangles = orient(morph.start).triangles;
  std::vector<std::uint32_t> corners;
  for (const auto& triangle : triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
  const Floats start = floats_of(morph.start.vertices, origin), normals = unit_normals(morph.start.vertices, triangles);
  ordered_json attributes, target;
  attributes["POSITION"] = add_bounded_table(content, start, 3, GltfTarget::vertices);
  attributes["NORMAL"] = add_table(content, normals, 3, GltfTarget::vertices);
  if (!colours.empty()) attributes["COLOR_0"] = add_colours(content, colours);
  target["POSITION"] = add_bounded_table(content, difference(floats_of(morph.end, origin), start), 3, GltfTarget::vertices);
  target["NORMAL"] = add_table(content, difference(unit_normals(morph.end, triangles), normals), 3, GltfTarget::vertices);
  const int indices = add_table(content, corners, 1, GltfTarget::triangles);
  return {{"attributes", attributes}, {"indices", indices}, {"material", 0}, {"targets", {target}}};
}

ordered_json animation_of(GltfContent& content) {
  const int times = add_bounded_table(content, {0, 2, 4}, 1, GltfTarget::none),
            weights = add_table(content, Floats{0, 1, 0}, 1, GltfTarget::none);
  return {{"name", "model to data and back"},
          {"samplers", {{{"input", times}, {"interpolation", "LINEAR"}, {"output", weights}}}},
          {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}};
}

}  // namespace

Morph make_morph(const MatchMap& match, const Mesh& model, const DenseMaps& maps) {
  Morph morph{{model.vertices, carried_triangles(match, model), model.ras}, maps.laid_vertices};
  for (Vec3& vertex : morph.start.vertices) vertex = (match.similarity * vertex.homogeneous()).head<3>();
  return morph;
}

Mesh frame_of(const Morph& morph, double share) {
  Mesh frame = morph.start;
  for (std::size_t i = 0; i < frame.vertices.size(); ++i) frame.vertices[i] = (1 - share) * frame.vertices[i] + share * morph.end[i];
  return frame;
}

std::string morph_glb(const Morph& morph, const std::vector<Colour>& colours) {
  const Box box = bounding_box(morph.start);
  const Vec3 origin = (box.min + box.max) / 2;
  GltfContent content;
  const ordered_json primitive = primitive_of(content, morph, origin, colours), animation = animation_of(content);
  const ordered_json material = {{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.8}}}, {"doubleSided", true}};
  const ordered_json json = {{"scene", 0},
                             {"scenes", {{{"nodes", {0}}}}},
                             {"nodes", {{{"mesh", 0}, {"translation", {origin.x(), origin.y(), origin.z()}}}}},
                             {"meshes", {{{"primitives", {primitive}}, {"weights", {0}}, {"extras", {{"targetNames", {"data"}}}}}}},
                             {"materials", {material}},
                             {"animations", {animation}}};
  return glb_bytes(gltf_document(json, content), content);
}

}  // namespace homolog
