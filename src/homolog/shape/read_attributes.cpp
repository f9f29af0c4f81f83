// SPDX-License-Identifier: MIT
#include "homolog/shape/read_attributes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "homolog/base/errors.h"
#include "homolog/shape/find_picture.h"
#include "homolog/shape/read_gltf.h"
#include "homolog/shape/read_gltf_attributes.h"
#include "homolog/shape/read_obj_attributes.h"
#include "homolog/shape/read_ply_attributes.h"

namespace homolog {
namespace {

/// Takes the name of the mesh's file off pictures that were written with it ("a.skin.png" beside "a.obj"), or it would grow at every pass.
void shorten_names(std::vector<Image>& images, const std::filesystem::path& path) {
  const std::string stem = path.stem().string() + ".";
  for (Image& image : images) {
    const std::string rest = image.name.starts_with(stem) ? image.name.substr(stem.size()) : "";
    if (!image.bytes.empty() && std::filesystem::path(rest).has_extension()) image.name = free_name(images, rest);
  }
}

}  // namespace

AttributedMesh read_attributes(const std::filesystem::path& path, const ReadLimits& limits) {
  read_mesh(path, limits);  // which refuses what cannot be used
  const std::string content = read_file(path, limits.bytes), file = path.string();
  std::vector<std::filesystem::path> files{path};
  const FindOther find_other = [&](const std::string& name) {
    files.push_back(path.parent_path() / name);
    return find_beside(path, name, limits.bytes);
  };
  AttributedMesh mesh;
  if (content.compare(0, 3, "ply") == 0) {
    mesh = read_ply_attributes(content, file, find_other);
  } else if (lower_extension(path) == ".obj") {
    mesh = read_obj_attributes(content, file, find_other);
  } else if (is_gltf(content)) {
    mesh = read_gltf_attributes(content, file, find_other, limits.triangles);
  } else {
    throw FileError(fmt::format("{}: colours, UVs and the like are read from {}; save it as one of these", file, readable_attributes));
  }
  if (mesh.mesh.triangles.empty()) {
    throw FileError(fmt::format("{}: it is a point cloud, whose points are no corners of a surface; paint a mesh instead", file));
  }
  if (told_attributes(mesh).empty() && !mesh.left_out.empty()) {
    throw FileError(fmt::format("{}: all that it says beside the form is not carried: {}", file, fmt::join(mesh.left_out, "; ")));
  }
  if (told_attributes(mesh).empty()) {
    throw FileError(fmt::format("{}: it says nothing but the form, neither colours nor UVs nor values; export it with them", file));
  }
  shorten_names(mesh.texturing.images, path);
  mesh.files = std::move(files);
  return mesh;
}

}  // namespace homolog
