// SPDX-License-Identifier: MIT
// The nodes of a glTF file's scene: where they stand and what hangs on them.
#pragma once

#include "homolog/shape/gltf_file.h"

namespace homolog {

struct GltfNode {
  std::size_t number;                 ///< in the document's "nodes"
  std::optional<std::size_t> parent;  ///< in the list of nodes of the scene
  Mat4 local;                         ///< parent_from_node, of homogeneous columns
  Mat4 world;                         ///< world_from_node
  bool is_hidden;                     ///< it or one above says so (KHR_node_visibility): its mesh is not shown
};

/// What a node says by its translation, rotation and scale. Throws FileError.
Pose stated_pose(const GltfFile& file, const nlohmann::json& node);

/// The nodes of the scene that the file shows (all nodes if it names no scene), parents first. Throws FileError, also for nodes that have
/// two parents or none at the top.
std::vector<GltfNode> scene_nodes(const GltfFile& file);

}  // namespace homolog
