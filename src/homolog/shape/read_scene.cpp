// SPDX-License-Identifier: MIT
#include "homolog/shape/read_scene.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/Importer.hpp>
#include <exception>
#include <new>

#include "homolog/base/errors.h"
#include "homolog/shape/foreign_file.h"
#include "homolog/shape/read_in_child.h"
#include "homolog/shape/text.h"
#include "homolog/shape/weld.h"

namespace homolog {
namespace {

constexpr std::size_t bytes_a_second = 1 << 20;  // the slowest that an undamaged file is read

/// A scene names other files (textures), which are none of its business.
struct NoFiles : Assimp::DefaultIOSystem {
  bool Exists(const char*) const override { return false; }
  Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
};

aiMatrix4x4 world_from(const aiNode* node) {
  aiMatrix4x4 matrix;
  for (; node; node = node->mParent) matrix = node->mTransformation * matrix;
  return matrix;
}

/// Where the vertices of a node's mesh stand: by its joints, as those of a glTF, where it has any, else by the node.
std::vector<aiVector3D> placed(const aiMesh& part, const aiNode& node, const aiScene& scene, const std::string& file) {
  std::vector<aiVector3D> places(part.mNumVertices);
  std::vector<float> weights(part.mNumVertices);
  for (unsigned b = 0; b < part.mNumBones; ++b) {
    const aiBone& bone = *part.mBones[b];
    const aiNode* joint = scene.mRootNode->FindNode(bone.mName);
    const aiMatrix4x4 matrix = world_from(joint) * bone.mOffsetMatrix;
    for (unsigned i = 0; joint && i < bone.mNumWeights; ++i) {
      const auto& [vertex, weight] = bone.mWeights[i];
      if (vertex >= part.mNumVertices) throw FileError(fmt::format("{}: a joint moves vertex {}; the file is damaged", file, vertex));
      places[vertex] += weight * (matrix * part.mVertices[vertex]);
      weights[vertex] += weight;
    }
  }
  const aiMatrix4x4 own = world_from(&node);
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    if (weights[i] > 0)
      places[i] /= weights[i];
    else
      places[i] = own * part.mVertices[i];
  }
  return places;
}

void append(Mesh& mesh, const aiMesh& part, const std::vector<aiVector3D>& places, const std::string& file) {
  const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const aiVector3D& v : places) mesh.vertices.emplace_back(v.x, v.y, v.z);
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

void append(Mesh& mesh, const aiNode& node, const aiScene& scene, const std::string& file) {
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh& part = *scene.mMeshes[node.mMeshes[i]];
    append(mesh, part, placed(part, node, scene, file), file);
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) append(mesh, *node.mChildren[i], scene, file);
}

/// Whole, but without any mesh: assimp calls it damaged.
bool is_empty_collada(std::string_view content) {
  return content.find("mesh>") == content.npos && content.find("COLLADA>", content.size() / 2) != content.npos;
}

const char* name_of(const std::string& format) {
  return format == "fbx" ? "FBX" : format == "ac" ? "AC3D" : format == "dae" ? "COLLADA" : "3DS";
}

/// Before anything is made of it; null when it cannot be read, for reasons in assimp's words, which help nobody.
const aiScene* imported(Assimp::Importer& importer, std::string_view content, const std::string& format) {
  importer.SetIOHandler(new NoFiles);                                            // which the importer deletes
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);  // coordinates stay the file's
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  try {
    const aiScene* scene = importer.ReadFileFromMemory(content.data(), content.size(), 0, format.c_str());
    if (importer.GetException()) std::rethrow_exception(importer.GetException());
    if (format == "dae" && scene && scene->mRootNode)
      scene->mRootNode->mTransformation = aiMatrix4x4();  // else metres are made of its unit
    if (scene) scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_SortByPType);
    return scene;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return nullptr;
  }
}

/// How many objects a file hides, which assimp does not tell.
std::size_t hidden_in(std::string_view content, const std::string& format) {
  std::size_t hidden = 0;
  const auto count = [&](std::string_view word) {
    for (std::size_t at = content.find(word); at != content.npos; at = content.find(word, at + word.size())) ++hidden;
  };
  if (format == "ac")
    for (const char* line : {"\nhidden\n", "\nhidden\r"}) count(line);
  if (format == "dae")
    for (const char* value : {"<visibility>0<", "<visibility>false<"}) count(value);
  return hidden;
}

Mesh read_by_assimp(std::string_view content, const std::string& format, const std::string& file) {
  Assimp::Importer importer;
  Mesh mesh;
  if (format == "dae" && is_empty_collada(content)) return mesh;
  const aiScene* scene = imported(importer, content, format);
  if (!scene) {
    throw FileError(fmt::format(
        "{}: it cannot be read as {}; it is damaged, or holds what the library that reads it does not know: export it again, or as glTF",
        file, name_of(format)));
  }
  if (scene->mRootNode) append(mesh, *scene->mRootNode, *scene, file);
  return weld(mesh);
}

}  // namespace

std::string scene_format(std::string_view content, const std::string& extension) {
  for (const std::string_view begin : {"Kaydara FBX Binary", "; FBX"}) {
    if (content.starts_with(begin)) return "fbx";
  }
  if (content.starts_with("AC3D")) return "ac";
  const std::string start = lower(content.substr(0, telling_bytes));
  const std::size_t first = start.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && start[first] == '<' && start.find("<collada") != std::string::npos) return "dae";
  return extension == ".3ds" && content.starts_with("MM") ? "3ds" : "";
}

Mesh read_scene(std::string_view content, const std::string& format, const std::string& file, const Tell& tell) {
  ChildLimits limits;
  limits.seconds += static_cast<unsigned>(content.size() / bytes_a_second);
  Mesh mesh = read_in_child([&] { return read_by_assimp(content, format, file); }, file, limits);
  if (const std::size_t hidden = tell ? hidden_in(content, format) : 0; hidden > 0)
    tell(fmt::format("{} hidden object{} read like the others; delete what does not belong to the shape", hidden,
                     hidden == 1 ? " is" : "s are"));
  return mesh;
}

}  // namespace homolog
