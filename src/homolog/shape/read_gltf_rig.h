// SPDX-License-Identifier: MIT
// Skins of glTF files.
#pragma once

#include <map>

#include "homolog/shape/gltf_scene.h"

namespace homolog {

/// What a skin does to a mesh as the nodes stand: a vertex goes to the sum of weight * world_from_joint * inverse bind matrix * vertex.
struct GltfSkin {
  std::vector<std::uint16_t> joints;  ///< for each number in the skin its number in GltfRig::joints()
  Mat4 first = Mat4::Identity();      ///< world_from_joint * inverse bind matrix of the first joint
  std::vector<Mat4> of_joints;        ///< of all by their numbers in GltfRig::joints(); empty: that of the first is all others', too
};

/// The joints of all skins of a scene, gathered as they are met. They are bound where their nodes stand, as the vertices are shown there.
class GltfRig {
 public:
  GltfRig(const GltfFile& file, const std::vector<GltfNode>& nodes);

  /// Adds the joints of a skin of the document. Throws FileError.
  GltfSkin add_skin(std::size_t skin);

  /// Gives every joint its parent.
  std::vector<Joint> joints() const;

  /// The number of the joint that a node of the document is; none if it is not one.
  std::optional<std::size_t> joint_of(std::size_t node) const;

 private:
  std::uint16_t add_joint(std::size_t node, const Mat4& inverse_bind);
  Mat4 world_of(std::size_t node, const Mat4& inverse_bind) const;

  const GltfFile& file_;
  const std::vector<GltfNode>& nodes_;
  std::vector<Joint> joints_;
  std::map<std::size_t, std::uint16_t> number_of_;  ///< of a node's number, the joint's
  std::map<std::size_t, std::size_t> place_of_;     ///< of a node's number, where it stands in the list of nodes
};

struct GltfInfluences {
  std::vector<Influences> of_vertices;  ///< the strongest eight of all sets
  bool has_more = false;                ///< whether a vertex followed more joints
};

/// The weights of a primitive's vertices for the joints of its skin. Throws FileError.
GltfInfluences read_gltf_influences(const GltfFile& file, const nlohmann::json& attributes, std::size_t vertices,
                                    const std::vector<std::uint16_t>& joints);

}  // namespace homolog
