// SPDX-License-Identifier: MIT
// Animations as glTF 2.0.
#pragma once

#include "homolog/outputs/glb.h"
#include "homolog/shape/attributes.h"

namespace homolog {

/// "animations" of a document in which node 0 shows the mesh with the shape keys, and node `first_joint` + i is joint i as it is bound in
/// its parent. What stands still is not written; null if nothing moves.
nlohmann::ordered_json gltf_animations(const AttributedMesh& mesh, std::size_t first_joint, GltfContent& content);

}  // namespace homolog
