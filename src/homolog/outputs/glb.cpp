// SPDX-License-Identifier: MIT
#include "homolog/outputs/glb.h"

#include <bit>
#include <cstring>
#include <limits>
#include <span>

#include "homolog/base/errors.h"
#include "homolog/outputs/json_text.h"
#include "homolog/shape/vertex_normals.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

// Of glTF.
enum : int { kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126 };

template <class T>
int add(GltfContent& content, const std::vector<T>& values, int columns, int component, GltfTarget target) {
  static constexpr const char* types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
  const auto bytes = std::as_bytes(std::span(values));
  const int view = add_view(content, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, target);
  content.accessors.push_back({{"bufferView", view},
                               {"componentType", component},
                               {"count", values.size() / columns},
                               {"type", columns == 16 ? "MAT4" : types[columns]}});
  return static_cast<int>(content.accessors.size()) - 1;
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

int add_view(GltfContent& content, std::string_view bytes, GltfTarget target) {
  ordered_json view = {{"buffer", 0}, {"byteOffset", content.bytes.size()}, {"byteLength", bytes.size()}};
  if (target != GltfTarget::none) view["target"] = static_cast<int>(target);
  content.views.push_back(view);
  content.bytes.append(bytes);
  content.bytes.resize((content.bytes.size() + 3) / 4 * 4, '\0');
  return static_cast<int>(content.views.size()) - 1;
}

int add_table(GltfContent& content, const Floats& values, int columns, GltfTarget target) {
  return add(content, values, columns, kFloat, target);
}
int add_table(GltfContent& content, const std::vector<std::uint32_t>& values, int columns, GltfTarget target) {
  return add(content, values, columns, kUnsignedInt, target);
}
int add_table(GltfContent& content, const std::vector<std::uint16_t>& values, int columns, GltfTarget target) {
  return add(content, values, columns, kUnsignedShort, target);
}
int add_table(GltfContent& content, const std::vector<std::uint8_t>& values, int columns, GltfTarget target) {
  return add(content, values, columns, kUnsignedByte, target);
}

int add_bounded_table(GltfContent& content, const Floats& values, int columns, GltfTarget target) {
  Floats least(values.begin(), values.begin() + columns), most = least;
  for (std::size_t i = 0; i < values.size(); ++i) {
    least[i % columns] = std::min(least[i % columns], values[i]);
    most[i % columns] = std::max(most[i % columns], values[i]);
  }
  const int accessor = add_table(content, values, columns, target);
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

Floats unit_normals(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles) {
  std::vector<Vec3> normals = oriented_normals({positions, triangles});
  for (Vec3& normal : normals) {
    if (normal.squaredNorm() == 0) normal = Vec3::UnitZ();
  }
  return floats_of(normals);
}

ordered_json gltf_document(const ordered_json& json, const GltfContent& content, const std::string& uri) {
  ordered_json document = {{"asset", {{"version", "2.0"}, {"generator", "homolog " HOMOLOG_VERSION}}}};
  document.update(json);
  ordered_json buffer = {{"byteLength", content.bytes.size()}};
  if (!uri.empty()) buffer["uri"] = uri;
  document["accessors"] = content.accessors;
  document["bufferViews"] = content.views;
  document["buffers"] = {buffer};
  return document;
}

std::string glb_bytes(const ordered_json& document, const GltfContent& content) {
  const std::string chunks = chunk("JSON", json_dump(document), ' ') + chunk("BIN\0", content.bytes, '\0');
  if (chunks.size() + 12 > std::numeric_limits<std::uint32_t>::max()) {
    throw OutputError("a .glb holds at most 4 GiB; simplify the mesh or leave attributes out");
  }
  return "glTF" + word(2) + word(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

}  // namespace homolog
