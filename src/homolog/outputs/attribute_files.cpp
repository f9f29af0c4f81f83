// SPDX-License-Identifier: MIT
#include "homolog/outputs/attribute_files.h"

#include <fmt/format.h>

#include "homolog/base/errors.h"
#include "homolog/base/read_file.h"
#include "homolog/outputs/attributes_gltf.h"
#include "homolog/outputs/attributes_obj.h"
#include "homolog/outputs/attributes_ply.h"
#include "homolog/outputs/gltf_materials.h"

namespace homolog {
namespace {

bool is_gltf(const std::filesystem::path& out) { return lower_extension(out) == ".glb" || lower_extension(out) == ".gltf"; }

}  // namespace

bool writes_attributes(const std::filesystem::path& out) {
  return is_gltf(out) || lower_extension(out) == ".ply" || lower_extension(out) == ".obj";
}

std::vector<OutputFile> attribute_files(const AttributedMesh& carried, const std::vector<DensePlace>& places,
                                        const std::filesystem::path& out, const std::string& from, const std::string& name) {
  if (!writes_attributes(out)) {
    throw OutputError(fmt::format("attributes are written as {}, not as '{}'", writable_attributes, out.string()));
  }
  if (is_gltf(out)) return attributes_gltf(carried, out, from, name);
  if (lower_extension(out) == ".obj") return attributes_obj(carried, out, from);
  return attributes_ply(carried, places, out, from);
}

std::vector<std::string> attribute_losses(const AttributedMesh& giver, const std::filesystem::path& out, const std::string& from) {
  std::vector<std::string> losses;
  for (const std::string& name : giver.missing) losses.push_back(fmt::format("{} names {}, which is not there", from, name));
  for (const std::string& what : giver.left_out) losses.push_back(fmt::format("{}: not carried: {}", from, what));
  const std::string ending = lower_extension(out);
  if (ending == ".obj" && !giver.fields.empty()) losses.emplace_back(".obj files hold no values and no labels; .ply and .glb files do");
  if (ending == ".obj" && says_more_than_base_colour(giver.texturing)) {
    losses.emplace_back("of materials an .obj holds the base colour and its picture alone; a .glb holds more");
  }
  if (ending == ".ply" && ply_leaves_out(giver.texturing)) {
    losses.emplace_back("of materials a .ply holds the pictures alone; an .obj or a .glb holds more");
  }
  if (is_gltf(out)) {
    for (const std::string& name : pictures_left_out(giver.texturing)) {
      losses.push_back(fmt::format("{} is no picture that glTF holds (PNG, JPEG)", name));
    }
  } else if (!giver.rig.joints.empty() || !giver.shape_keys.empty()) {
    losses.emplace_back("weights, joints, shape keys and animations are written to a .glb or .gltf alone");
  }
  return losses;
}

}  // namespace homolog
