// SPDX-License-Identifier: MIT
#include "homolog/shape/attributes.h"

#include <fmt/format.h>

#include "homolog/shape/text.h"

namespace homolog {

std::string told_attributes(const AttributedMesh& mesh) {
  std::string told;
  const auto add = [&told](const std::string& what) { told += (told.empty() ? "" : ", ") + what; };
  if (!mesh.colours.empty()) add("colours");
  for (const Field& field : mesh.fields) add((field.kind == Field::Kind::value ? "values " : "labels ") + shown(field.name));
  if (!mesh.texturing.uvs.empty()) add("UVs");
  if (const std::size_t count = mesh.texturing.materials.size(); count > 0) add(fmt::format("{} material{}", count, count == 1 ? "" : "s"));
  if (const std::size_t count = mesh.rig.joints.size(); count > 0) add(fmt::format("weights of {} joint{}", count, count == 1 ? "" : "s"));
  if (const std::size_t count = mesh.shape_keys.size(); count > 0) add(fmt::format("{} shape key{}", count, count == 1 ? "" : "s"));
  if (const std::size_t count = mesh.animations.size(); count > 0) add(fmt::format("{} animation{}", count, count == 1 ? "" : "s"));
  return told;
}

}  // namespace homolog
