// SPDX-License-Identifier: MIT
// Skins of glTF files.
#pragma once

#include <map>

#include "homolog/shape/gltf_scene.h"

namespace homolog {

/// The joints of all skins of a scene, gathered as they are met.
class GltfRig {
 public:
  GltfRig(const GltfFile& file, const std::vector<GltfNode>& nodes) : file_(file), nodes_(nodes) {}

  /// The joints of a skin on a mesh whose node stands at `world`: for each number in the skin its number in joints(). Throws FileError.
  std::vector<std::uint16_t> add_skin(std::size_t skin, const Mat4& world);

  /// Gives every joint its parent.
  std::vector<Joint> joints() const;

  /// The number of the joint that a node of the document is; none if it is not one.
  std::optional<std::size_t> joint_of(std::size_t node) const;

  /// Whether a joint was bound in two ways, of which the first is kept.
  bool is_bound_twice() const { return bound_twice_; }

 private:
  const GltfFile& file_;
  const std::vector<GltfNode>& nodes_;
  std::vector<Joint> joints_;
  std::map<std::size_t, std::uint16_t> number_of_;  ///< of a node's number, the joint's
  bool bound_twice_ = false;
};

struct GltfInfluences {
  std::vector<Influences> of_vertices;  ///< the strongest eight of all sets
  bool has_more = false;                ///< whether a vertex followed more joints
};

/// The weights of a primitive's vertices for the joints of its skin. Throws FileError.
GltfInfluences read_gltf_influences(const GltfFile& file, const nlohmann::json& attributes, std::size_t vertices,
                                    const std::vector<std::uint16_t>& joints);

}  // namespace homolog
