// SPDX-License-Identifier: MIT
#include "homolog/shape/read_gltf_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "homolog/base/read_file.h"
#include "homolog/shape/find_picture.h"
#include "homolog/shape/srgb.h"

namespace homolog {
namespace {

using nlohmann::json;

/// Whether this is how a texture is used, by other UVs than the first ones.
bool is_by_other_uvs(const json& use) {
  if (!use.is_object() || !use.contains("index")) return false;
  const auto other = [](const json& object) {
    const auto number = object.find("texCoord");
    return number != object.end() && *number != 0;
  };
  if (other(use)) return true;
  const auto extensions = use.find("extensions");
  return extensions != use.end() && extensions->is_object() && extensions->contains("KHR_texture_transform") &&
         other((*extensions)["KHR_texture_transform"]);
}

bool take_other_uvs_off(json& value) {
  bool taken = false;
  for (auto item = value.begin(); value.is_structured() && item != value.end();) {
    if (value.is_object() && is_by_other_uvs(*item)) {
      item = value.erase(item);
      taken = true;
    } else {
      taken |= item->is_structured() && take_other_uvs_off(*item);
      ++item;
    }
  }
  return taken;
}

json list_at(const GltfFile& file, const char* key) {
  const auto found = file.document.find(key);
  return found != file.document.end() && found->is_array() ? *found : json::array();
}

/// The name of a picture's file: its own, or one made of its name or number and its kind.
std::string picture_name(const json& image, std::size_t number, const std::string& uri) {
  if (!uri.empty() && uri.compare(0, 5, "data:") != 0) return std::filesystem::path(name_of_uri(uri)).filename().string();
  const std::string name = std::filesystem::path(text_at(image, "name")).filename().string();
  const std::string has = lower_extension(name);
  if (has == ".png" || has == ".jpg" || has == ".jpeg" || has == ".webp" || has == ".ktx2") return name;
  const char* ending = text_at(image, "mimeType") == "image/jpeg" || uri.compare(0, 15, "data:image/jpeg") == 0 ? ".jpg" : ".png";
  return (name.empty() ? fmt::format("image_{}", number) : name) + ending;
}

void read_images(const GltfFile& file, const FindOther& find_other, AttributedMesh& mesh) {
  std::vector<Image>& images = mesh.texturing.images;
  for (const json& image : list_at(file, "images")) {
    const std::string uri = text_at(image, "uri");
    const std::string name = free_name(images, picture_name(image, images.size(), uri));
    const auto find = [&]() -> std::optional<std::string> {
      if (const auto view = number_at(file, image, "bufferView")) return std::string(buffer_view(file, *view));
      return uri_bytes(file, uri, find_other);
    };
    images.push_back({name, picture_bytes(name, find, {mesh.missing, mesh.left_out}).value_or("")});
  }
}

/// The image of the material's base colour; -1: none.
int image_of(const GltfFile& file, const json& surface, const Texturing& texturing) {
  const auto use = surface.find("baseColorTexture");
  if (use == surface.end()) return -1;
  const auto texture = number_at(file, *use, "index");
  if (!texture) return -1;
  const auto image = number_at(file, entry(file, "textures", *texture), "source");
  if (!image) return -1;
  if (*image >= texturing.images.size()) fail(file, fmt::format("image {} does not exist", *image));
  return static_cast<int>(*image);
}

}  // namespace

void read_gltf_materials(const GltfFile& file, const FindOther& find_other, AttributedMesh& mesh) {
  Texturing& texturing = mesh.texturing;
  read_images(file, find_other, mesh);
  json materials = list_at(file, "materials");
  if (take_other_uvs_off(materials)) mesh.left_out.emplace_back("textures by a second set of UVs");
  for (const json& given : materials) {
    const auto found = given.find("pbrMetallicRoughness");
    const json surface = found != given.end() ? *found : json::object();
    Material material{text_at(given, "name"), {1, 1, 1, 1}, image_of(file, surface, texturing)};
    if (const auto colour = floats_at(file, surface, "baseColorFactor", 4)) {
      for (int k = 0; k < 4; ++k) material.colour[k] = static_cast<float>(std::clamp((*colour)[k], 0.0, 1.0));
      material.colour = srgb_of_linear(material.colour);
    }
    if (material.name.empty()) material.name = fmt::format("material_{}", texturing.materials.size());
    material.name = free_name(texturing.materials, material.name);
    texturing.materials.push_back(material);
  }
  if (texturing.materials.empty()) return;
  json told = {{"materials", materials}, {"textures", list_at(file, "textures")}, {"samplers", list_at(file, "samplers")}};
  if (const json required = list_at(file, "extensionsRequired"); !required.empty()) told["extensionsRequired"] = required;
  texturing.gltf = told.dump();
}

}  // namespace homolog
