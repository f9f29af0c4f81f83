// SPDX-License-Identifier: MIT
// Beyond the paper: joints with their weights, and shape keys, carried from one mesh to the other by a dense map.
#pragma once

#include "homolog/match/dense.h"
#include "homolog/shape/attributes.h"

namespace homolog {

/// What a dense map says of the receiver: the places of its vertices on giver.mesh, and whether the map mirrors.
struct GiverPlaces {
  const std::vector<DensePlace>& places;
  Chirality chirality;
};

/// The giver's joints within the receiver, and the weights of its vertices. Weights lie between those of the corners of a place's triangle,
/// of which the strongest four are kept (eight if the giver has vertices with more than four); a vertex without a place follows what the
/// nearest one with a place along the surface does, a piece of which no vertex has one what the nearest such vertex does. A joint goes
/// where the best similarity (local_similarity.h) of the places that follow it or its parent (of all, if none does) puts it, of weight area
/// * influence^2 / (distance^2 + d^2)^2, where d is the distance of the nearest one. It turns as the best similarity of those that follow
/// itself does, each of weight area * influence^2, and does not scale; under a mirroring map its x axis is reversed, so that turns about
/// that axis look mirrored.
Rig carry_rig(const AttributedMesh& giver, const Mesh& receiver, const GiverPlaces& on_giver);

/// The giver's shape keys on the receiver: each displacement is turned and scaled as the surface about the place is (3 % of the receiver's
/// diagonal). That of a vertex without a place fades from the nearest one's along the surface, within 5 % of the diagonal.
std::vector<ShapeKey> carry_shape_keys(const AttributedMesh& giver, const Mesh& receiver, const GiverPlaces& on_giver);

/// For every vertex the nearest one along the edges that has a place, itself if it has one.
struct NearestPlaced {
  static constexpr std::uint32_t none = DensePlace::none;
  std::vector<std::uint32_t> vertex;  ///< none for those of pieces without any
  std::vector<double> distance;
};
NearestPlaced nearest_placed(const Mesh& mesh, const std::vector<DensePlace>& places);

}  // namespace homolog
