// SPDX-License-Identifier: MIT
#include "homolog/outputs/morph.h"

#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>

#include "homolog/shape/orient.h"
#include "homolog/shape/vertex_normals.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

using Floats = std::vector<float>;

// Of glTF.
enum : int { kUnsignedByte = 5121, kUnsignedInt = 5125, kFloat = 5126 };
enum : int { kNoTarget = 0, kArrayBuffer = 34962, kElementArrayBuffer = 34963 };

/// The binary part of a file, and the list of what lies in it.
struct Content {
  std::string bytes;
  ordered_json views = ordered_json::array(), accessors = ordered_json::array();
};

/// Adds values of `columns` numbers each and returns the number of their accessor.
template <class T>
int add(Content& content, const std::vector<T>& values, int columns, int component, int target) {
  static constexpr const char* types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
  const auto bytes = std::as_bytes(std::span(values));
  ordered_json view = {{"buffer", 0}, {"byteOffset", content.bytes.size()}, {"byteLength", bytes.size()}};
  if (target != kNoTarget) view["target"] = target;
  content.views.push_back(view);
  content.bytes.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  content.bytes.resize((content.bytes.size() + 3) / 4 * 4, '\0');
  content.accessors.push_back({{"bufferView", content.views.size() - 1},
                               {"componentType", component},
                               {"count", values.size() / columns},
                               {"type", types[columns]}});
  return static_cast<int>(content.accessors.size()) - 1;
}

/// The same for floats, with the least and the most of every column, which glTF asks for of positions and times.
int add_with_bounds(Content& content, const Floats& values, int columns, int target) {
  Floats least(values.begin(), values.begin() + columns), most = least;
  for (std::size_t i = 0; i < values.size(); ++i) {
    least[i % columns] = std::min(least[i % columns], values[i]);
    most[i % columns] = std::max(most[i % columns], values[i]);
  }
  const int accessor = add(content, values, columns, kFloat, target);
  content.accessors.back()["min"] = least;
  content.accessors.back()["max"] = most;
  return accessor;
}

Floats floats_of(const std::vector<Vec3>& vectors, const Vec3& origin) {
  Floats floats;
  for (const Vec3& v : vectors) {
    for (int k = 0; k < 3; ++k) floats.push_back(static_cast<float>(v[k] - origin[k]));
  }
  return floats;
}

Floats difference(const Floats& a, const Floats& b) {
  Floats result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] - b[i];
  return result;
}

/// Normals of unit length, as glTF wants them, also where a vertex has no triangle.
Floats unit_normals(const std::vector<Vec3>& positions, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::vector<Vec3> normals = oriented_normals({positions, triangles});
  for (Vec3& normal : normals) {
    if (normal.squaredNorm() == 0) normal = Vec3::UnitZ();
  }
  return floats_of(normals, Vec3::Zero());
}

int add_colours(Content& content, const std::vector<Colour>& colours) {
  std::vector<std::uint8_t> values;  // four a vertex, so that each begins at a multiple of four bytes
  for (const Colour& colour : colours) values.insert(values.end(), {colour[0], colour[1], colour[2], 255});
  const int accessor = add(content, values, 4, kUnsignedByte, kArrayBuffer);
  content.accessors.back()["normalized"] = true;
  return accessor;
}

/// The mesh's one primitive.
ordered_json primitive_of(Content& content, const Morph& morph, const Vec3& origin, const std::vector<Colour>& colours) {
  const auto triangles = orient(morph.start).triangles;
  std::vector<std::uint32_t> corners;
  for (const auto& triangle : triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
  const Floats start = floats_of(morph.start.vertices, origin), normals = unit_normals(morph.start.vertices, triangles);
  ordered_json attributes, target;
  attributes["POSITION"] = add_with_bounds(content, start, 3, kArrayBuffer);
  attributes["NORMAL"] = add(content, normals, 3, kFloat, kArrayBuffer);
  if (!colours.empty()) attributes["COLOR_0"] = add_colours(content, colours);
  target["POSITION"] = add_with_bounds(content, difference(floats_of(morph.end, origin), start), 3, kArrayBuffer);
  target["NORMAL"] = add(content, difference(unit_normals(morph.end, triangles), normals), 3, kFloat, kArrayBuffer);
  const int indices = add(content, corners, 1, kUnsignedInt, kElementArrayBuffer);
  return {{"attributes", attributes}, {"indices", indices}, {"material", 0}, {"targets", {target}}};
}

ordered_json animation_of(Content& content) {
  const int times = add_with_bounds(content, {0, 2, 4}, 1, kNoTarget), weights = add(content, Floats{0, 1, 0}, 1, kFloat, kNoTarget);
  return {{"name", "model to data and back"},
          {"samplers", {{{"input", times}, {"interpolation", "LINEAR"}, {"output", weights}}}},
          {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}};
}

std::string word(std::uint32_t value) {
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &value, 4);
  return bytes;
}

std::string chunk(const char* type, std::string bytes, char padding) {
  bytes.resize((bytes.size() + 3) / 4 * 4, padding);
  return word(static_cast<std::uint32_t>(bytes.size())) + std::string(type, 4) + bytes;
}

}  // namespace

Morph make_morph(const MatchMap& match, const Mesh& model, const DenseMaps& maps) {
  Morph morph{model, maps.laid_vertices};
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
  Content content;
  const ordered_json primitive = primitive_of(content, morph, origin, colours), animation = animation_of(content);
  const ordered_json material = {{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.8}}}, {"doubleSided", true}};
  const ordered_json json = {{"asset", {{"version", "2.0"}, {"generator", "homolog " HOMOLOG_VERSION}}},
                             {"scene", 0},
                             {"scenes", {{{"nodes", {0}}}}},
                             {"nodes", {{{"mesh", 0}, {"translation", {origin.x(), origin.y(), origin.z()}}}}},
                             {"meshes", {{{"primitives", {primitive}}, {"weights", {0}}, {"extras", {{"targetNames", {"data"}}}}}}},
                             {"materials", {material}},
                             {"animations", {animation}},
                             {"accessors", content.accessors},
                             {"bufferViews", content.views},
                             {"buffers", {{{"byteLength", content.bytes.size()}}}}};
  const std::string chunks = chunk("JSON", json.dump(), ' ') + chunk("BIN\0", content.bytes, '\0');
  return "glTF" + word(2) + word(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

}  // namespace homolog
