// SPDX-License-Identifier: MIT
#include "homolog/shape/read_scene.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>

#include "homolog/base/errors.h"
#include "homolog/base/read_file.h"
#include "homolog/shape/read_in_child.h"
#include "homolog/shape/text.h"
#include "homolog/shape/weld.h"

namespace homolog {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t bytes_a_second = 1 << 20;  // the slowest that an undamaged file is read

/// Opens what lies in one folder and below. A file names others (textures), and must not name what is none of its business.
class OneFolder : public Assimp::DefaultIOSystem {
 public:
  explicit OneFolder(const fs::path& file) : file_(file.string()), folder_(fs::canonical(fs::absolute(file).parent_path())) {}

  bool Exists(const char* name) const override { return is_inside(name) && DefaultIOSystem::Exists(name); }
  Assimp::IOStream* Open(const char* name, const char* mode) override {
    const bool reads = mode[0] == 'r' && std::string_view(mode).find('+') == std::string_view::npos;
    return reads && is_inside(name) ? DefaultIOSystem::Open(name, mode) : nullptr;
  }

 private:
  bool is_inside(const char* name) const {
    if (name == file_) return true;
    std::error_code error;
    const fs::path path = fs::canonical(name, error);  // links followed
    if (error || !fs::is_regular_file(path, error)) return false;
    return std::mismatch(folder_.begin(), folder_.end(), path.begin(), path.end()).first == folder_.end();
  }

  std::string file_;
  fs::path folder_;
};

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

Mesh read_by_assimp(const fs::path& path) {
  Assimp::Importer importer;
  importer.SetIOHandler(new OneFolder(path));                                    // which the importer deletes
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);  // coordinates stay the file's
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene = nullptr;
  std::string reason;
  try {
    scene = importer.ReadFile(path.string(), aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_PreTransformVertices);
    reason = importer.GetErrorString();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    reason = error.what();
  }
  if (!scene || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE && scene->mNumMeshes == 0)) {
    if (reason.empty()) reason = "no mesh is in it";
    throw FileError(
        fmt::format("{}: the file cannot be read ({}); it is truncated or damaged, export it again", path.string(), shown(reason, 120)));
  }
  Mesh mesh;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) append(mesh, *scene->mMeshes[i], path.string());
  return weld(mesh);
}

}  // namespace

const std::vector<std::string>& scene_extensions() {
  static const std::vector<std::string> extensions{".ac", ".dae", ".fbx", ".3ds"};
  return extensions;
}

Mesh read_scene(const fs::path& path) {
  ChildLimits limits;
  limits.seconds += static_cast<unsigned>(fs::file_size(path) / bytes_a_second);
  return read_in_child([&] { return read_by_assimp(path); }, path.string(), limits);
}

}  // namespace homolog
