// SPDX-License-Identifier: MIT
#include "homolog/outputs/attributes_obj.h"

#include <fmt/format.h>

#include <utility>

#include "homolog/outputs/pictures.h"
#include "homolog/outputs/specimen.h"

namespace homolog {
namespace {

constexpr const char* bare_material = "not_carried";

std::string mtl_text(const Texturing& texturing, const std::filesystem::path& out) {
  std::string text = fmt::format("newmtl {}\nKd 0.5 0.5 0.5\n", bare_material);
  for (const Material& material : texturing.materials) {
    const auto& [red, green, blue, alpha] = material.colour;
    text += fmt::format("\nnewmtl {}\nKd {} {} {}\nd {}\n", one_line(material.name), red, green, blue, alpha);
    if (material.image >= 0) text += fmt::format("map_Kd {}\n", picture_name(out, texturing.images[material.image]));
  }
  return text;
}

std::string vertices_text(const AttributedMesh& mesh) {
  std::string text;
  for (std::size_t i = 0; i < mesh.mesh.vertices.size(); ++i) {
    const Vec3& v = mesh.mesh.vertices[i];
    text += fmt::format("v {} {} {}", v.x(), v.y(), v.z());
    if (!mesh.colours.empty()) text += fmt::format(" {} {} {}", mesh.colours[i][0], mesh.colours[i][1], mesh.colours[i][2]);
    text += '\n';
  }
  for (const auto& [u, v] : mesh.texturing.uvs) text += fmt::format("vt {} {}\n", u, v);
  return text;
}

std::string faces_text(const AttributedMesh& mesh) {
  const Texturing& texturing = mesh.texturing;
  const bool has_materials = !texturing.materials.empty();
  std::string text;
  for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
    const int material = has_materials ? texturing.material_of[t] : -1;
    if (has_materials && (t == 0 || material != texturing.material_of[t - 1])) {
      text += fmt::format("usemtl {}\n", material < 0 ? bare_material : one_line(texturing.materials[material].name));
    }
    text += 'f';
    const bool has_uvs = !texturing.corners.empty() && texturing.has_uvs(t);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.mesh.triangles[t][k] + 1;
      text += has_uvs ? fmt::format(" {}/{}", vertex, texturing.corners[t][k] + 1) : fmt::format(" {}", vertex);
    }
    text += '\n';
  }
  return text;
}

}  // namespace

std::vector<OutputFile> attributes_obj(const AttributedMesh& mesh, const std::filesystem::path& out, const std::string& from) {
  const Texturing& texturing = mesh.texturing;
  const std::filesystem::path mtl = out.parent_path() / (out.stem().string() + ".mtl");
  std::string text = fmt::format("# carried from {}\n", one_line(from));
  if (!texturing.materials.empty()) text += fmt::format("mtllib {}\n", mtl.filename().string());
  std::vector<OutputFile> files{{out, text + vertices_text(mesh) + faces_text(mesh)}};
  if (texturing.materials.empty()) return files;
  files.push_back({mtl, mtl_text(texturing, out)});
  for (OutputFile& picture : picture_files(texturing, out)) files.push_back(std::move(picture));
  return files;
}

}  // namespace homolog
