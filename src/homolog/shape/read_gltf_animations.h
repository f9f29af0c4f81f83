// SPDX-License-Identifier: MIT
// Animations of glTF files.
#pragma once

#include "homolog/shape/read_gltf_rig.h"

namespace homolog {

/// Of a node that shows a mesh, which shape key each target of the mesh is.
using TargetsOfNodes = std::map<std::size_t, std::vector<std::size_t>>;

/// What animations move.
struct GltfActors {
  const std::vector<GltfNode>& nodes;
  const GltfRig& rig;
  const std::vector<ShapeKey>& keys;
  const TargetsOfNodes& targets;
};

/// Reads the animations into mesh.animations, all that is above a joint included: poses at the times of all curves. Those that move neither
/// joints nor shape keys and those of more than five million poses go into mesh.left_out. Throws FileError.
void read_gltf_animations(const GltfFile& file, const GltfActors& actors, AttributedMesh& mesh);

}  // namespace homolog
