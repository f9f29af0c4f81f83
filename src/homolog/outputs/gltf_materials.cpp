// SPDX-License-Identifier: MIT
#include "homolog/outputs/gltf_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "homolog/shape/srgb.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;

void gather_extensions(const ordered_json& value, std::set<std::string>& names) {
  for (const auto& item : value.items()) {
    if (value.is_object() && item.key() == "extensions" && item.value().is_object()) {
      for (const auto& extension : item.value().items()) names.insert(extension.key());
    }
    if (item.value().is_structured()) gather_extensions(item.value(), names);
  }
}

ordered_json image_of(const Image& image, GltfContent& content) {
  if (picture_type(image.bytes).empty()) return {{"uri", uri_of_name(image.name)}};
  return {{"name", image.name}, {"mimeType", picture_type(image.bytes)}, {"bufferView", add_view(content, image.bytes, GltfTarget::none)}};
}

/// What an OBJ says of its materials, which shine as little as they do there.
ordered_json made_materials(const Texturing& texturing, GltfContent& content) {
  ordered_json made, materials = ordered_json::array(), textures = ordered_json::array(), images = ordered_json::array();
  std::vector<int> texture_of(texturing.images.size(), -1);
  for (std::size_t i = 0; i < texturing.images.size(); ++i) {
    if (picture_type(texturing.images[i].bytes).empty()) continue;
    texture_of[i] = static_cast<int>(textures.size());
    textures.push_back({{"source", images.size()}});
    images.push_back(image_of(texturing.images[i], content));
  }
  for (const Material& material : texturing.materials) {
    const int texture = material.image < 0 ? -1 : texture_of[material.image];
    ordered_json surface = {{"metallicFactor", 0}, {"roughnessFactor", 0.8}};
    if (texture >= 0) surface["baseColorTexture"] = {{"index", texture}};
    if (texture < 0 || material.colour != Rgba{1, 1, 1, 1}) surface["baseColorFactor"] = linear_of_srgb(material.colour);
    materials.push_back({{"name", material.name}, {"pbrMetallicRoughness", surface}, {"doubleSided", true}});
    if (material.colour[3] < 1) materials.back()["alphaMode"] = "BLEND";
  }
  return {{"materials", materials}, {"textures", textures}, {"images", images}};
}

ordered_json kept_materials(const Texturing& texturing, GltfContent& content) {
  ordered_json kept = ordered_json::parse(texturing.gltf), images = ordered_json::array(), required = ordered_json::array();
  for (const Image& image : texturing.images) images.push_back(image_of(image, content));
  kept["images"] = images;
  std::set<std::string> used;
  gather_extensions(kept, used);
  for (const ordered_json& name : kept.value("extensionsRequired", ordered_json::array())) {
    if (name.is_string() && used.contains(name.get<std::string>())) required.push_back(name);  // others were those of its meshes
  }
  kept["extensionsUsed"] = used;
  kept["extensionsRequired"] = required;
  return kept;
}

bool says_more(const ordered_json& material) {
  for (const auto& item : material.items()) {
    const std::string& key = item.key();
    const bool is_base = key == "name" || key == "doubleSided" || key.starts_with("baseColor");
    if (key == "pbrMetallicRoughness" ? says_more(item.value()) : !is_base) return true;
  }
  return false;
}

}  // namespace

ordered_json gltf_materials(const Texturing& texturing, GltfContent& content) {
  if (texturing.materials.empty()) return ordered_json::object();
  const ordered_json lists = texturing.gltf.empty() ? made_materials(texturing, content) : kept_materials(texturing, content);
  ordered_json needed = ordered_json::object();
  for (const auto& list : lists.items()) {
    if (!list.value().empty()) needed[list.key()] = list.value();
  }
  return needed;
}

bool says_more_than_base_colour(const Texturing& texturing) {
  if (texturing.gltf.empty()) return false;
  const ordered_json materials = ordered_json::parse(texturing.gltf)["materials"];
  return std::any_of(materials.begin(), materials.end(), says_more);
}

std::string picture_type(const std::string& bytes) {
  if (bytes.compare(0, 4, "\x89PNG") == 0) return "image/png";
  if (bytes.compare(0, 3, "\xff\xd8\xff") == 0) return "image/jpeg";
  if (bytes.size() >= 12 && bytes.compare(0, 4, "RIFF") == 0 && bytes.compare(8, 4, "WEBP") == 0) return "image/webp";
  if (bytes.compare(0, 7, "\xabKTX 20") == 0) return "image/ktx2";
  return "";
}

std::string uri_of_name(const std::string& name) {
  std::string uri;
  for (const char c : name) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || std::string_view("-._~").find(c) != std::string_view::npos;
    uri += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

}  // namespace homolog
