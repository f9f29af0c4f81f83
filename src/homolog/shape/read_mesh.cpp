// SPDX-License-Identifier: MIT
// OFF, OBJ, PLY and STL by our own readers (their heads say why), everything else by assimp.
#include "homolog/shape/read_mesh.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/Importer.hpp>

#include "homolog/base/errors.h"
#include "homolog/base/read_file.h"
#include "homolog/shape/read_obj.h"
#include "homolog/shape/read_off.h"
#include "homolog/shape/read_ply.h"
#include "homolog/shape/read_stl.h"
#include "homolog/shape/weld.h"

namespace homolog {
namespace {

constexpr std::size_t most_triangles = 50'000'000;

void append(Mesh& mesh, const aiMesh& part, const std::string& file) {
  const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D& v = part.mVertices[i];
    mesh.vertices.emplace_back(v.x, v.y, v.z);
  }
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    if (face.mNumIndices != 3) continue;
    for (int k = 0; k < 3; ++k) {
      if (face.mIndices[k] >= part.mNumVertices) {
        throw FileError(fmt::format("{}, face {}: vertex {} does not exist; the file is damaged", file, i, face.mIndices[k]));
      }
    }
    mesh.triangles.push_back({offset + face.mIndices[0], offset + face.mIndices[1], offset + face.mIndices[2]});
  }
}

/// Every format but our own four: all nodes of the scene with their transforms applied, vertices welded.
Mesh read_by_assimp(const std::filesystem::path& path) {
  const std::string file = path.string();
  Assimp::Importer importer;
  if (!importer.IsExtensionSupported(lower_extension(path))) {
    throw FileError(
        fmt::format("{}: the format '{}' is not known; save the mesh as OFF, OBJ, PLY, STL or glTF", file, lower_extension(path)));
  }
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene = nullptr;
  std::string reason;
  try {
    scene = importer.ReadFile(file, aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_PreTransformVertices);
    reason = importer.GetErrorString();
  } catch (const std::exception& error) {
    reason = error.what();
  }
  if (!scene || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE && scene->mNumMeshes == 0)) {
    throw FileError(fmt::format("{}: the file cannot be read ({}); it is truncated or damaged, export it again", file, reason));
  }
  Mesh mesh;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) append(mesh, *scene->mMeshes[i], file);
  return weld(mesh);
}

void check_mesh(const Mesh& mesh, const std::string& file) {
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

Mesh read_mesh(const std::filesystem::path& path) {
  check_file(path);
  const std::string extension = lower_extension(path);
  Mesh mesh;
  if (extension == ".off") {
    mesh = read_off(read_file(path), path.string());
  } else if (extension == ".obj") {
    mesh = read_obj(read_file(path), path.string());
  } else if (extension == ".ply") {
    mesh = read_ply(read_file(path), path.string());
  } else if (extension == ".stl") {
    mesh = weld(read_stl(read_file(path), path.string()));
  } else {
    mesh = read_by_assimp(path);
  }
  check_mesh(mesh, path.string());
  return mesh;
}

}  // namespace homolog
