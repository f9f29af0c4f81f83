// SPDX-License-Identifier: MIT
// OFF, OBJ, PLY and STL by our own readers (their heads say why), scenes by assimp behind a fence (read_scene.h).
#include "homolog/shape/read_mesh.h"

#include <fmt/format.h>

#include <algorithm>

#include "homolog/base/errors.h"
#include "homolog/base/read_file.h"
#include "homolog/shape/read_obj.h"
#include "homolog/shape/read_off.h"
#include "homolog/shape/read_ply.h"
#include "homolog/shape/read_scene.h"
#include "homolog/shape/read_stl.h"
#include "homolog/shape/weld.h"

namespace homolog {
namespace {

void check_mesh(const Mesh& mesh, const std::string& file, std::size_t most_triangles) {
  if (mesh.triangles.empty()) throw FileError(fmt::format("{}: the file holds no triangles; export the surface as a mesh", file));
  if (mesh.triangles.size() > most_triangles) {
    throw FileError(
        fmt::format("{}: {} triangles are more than the {} that are read; simplify the mesh", file, mesh.triangles.size(), most_triangles));
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (!mesh.vertices[i].allFinite()) {
      throw FileError(fmt::format("{}, vertex {}: a coordinate is not a finite number; the file is damaged", file, i));
    }
  }
}

}  // namespace

Mesh read_mesh(const std::filesystem::path& path, const ReadLimits& limits) {
  check_file(path, limits.bytes);
  const std::string extension = lower_extension(path);
  Mesh mesh;
  if (extension == ".off") {
    mesh = read_off(read_file(path, limits.bytes), path.string());
  } else if (extension == ".obj") {
    mesh = read_obj(read_file(path, limits.bytes), path.string());
  } else if (extension == ".ply") {
    mesh = read_ply(read_file(path, limits.bytes), path.string());
  } else if (extension == ".stl") {
    mesh = weld(read_stl(read_file(path, limits.bytes), path.string()));
  } else if (const auto& scenes = scene_extensions(); std::find(scenes.begin(), scenes.end(), extension) != scenes.end()) {
    mesh = read_scene(path);
  } else {
    throw FileError(fmt::format("{}: the format '{}' is not known; save the mesh as OFF, OBJ, PLY, STL or one of {}", path.string(),
                                extension, fmt::join(scenes, ", ")));
  }
  check_mesh(mesh, path.string(), limits.triangles);
  return mesh;
}

}  // namespace homolog
