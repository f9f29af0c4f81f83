// SPDX-License-Identifier: MIT
// Meshes of glTF files where their nodes show them. As the standard says, the node of a skinned mesh does not move it: its joints do.
#pragma once

#include "homolog/shape/gltf_primitives.h"
#include "homolog/shape/read_gltf_rig.h"

namespace homolog {

/// A mesh as a node shows it.
struct GltfInstance {
  std::size_t node;  ///< in the document's "nodes"
  const nlohmann::json& mesh;
  Mat4 world;  ///< of the node, which moves what has no skin
  std::optional<GltfSkin> skin;
  std::vector<double> weights;  ///< of the targets: the node's own, else the mesh's
};

/// What a node shows; none if it shows no mesh. Throws FileError.
std::optional<GltfInstance> instance_of(const GltfFile& file, const GltfNode& node, GltfRig& rig);

/// What takes the vertices of a primitive from their table into the scene.
struct GltfPlacing {
  Mat4 all;                            ///< what all follow
  std::vector<Mat4> of_joints;         ///< by numbers of GltfRig::joints(); empty: all vertices go alike
  std::vector<Influences> influences;  ///< of the vertices; empty if they follow no joints
  bool has_weaker_weights = false;     ///< whether a vertex follows more joints than its influences name

  Mat4 at(std::size_t vertex) const;
};

/// Vertices without weights go with the first joint. Throws FileError.
GltfPlacing placing_of(const GltfFile& file, const GltfInstance& instance, const nlohmann::json& primitive, std::size_t vertices);

/// The vertices of a primitive in the scene, its targets applied by their weights. Throws FileError.
std::vector<Vec3> placed_vertices(const GltfFile& file, const GltfInstance& instance, const nlohmann::json& primitive,
                                  const GltfTable& positions, const GltfPlacing& placing);

/// How far a target moves each vertex, as the tables say; none if it moves none. Throws FileError.
std::optional<GltfTable> target_of(const GltfFile& file, const nlohmann::json& target, std::size_t vertices);

}  // namespace homolog
