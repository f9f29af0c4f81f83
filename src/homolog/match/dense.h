// SPDX-License-Identifier: MIT
// Beyond the paper, which names it as future work: for every vertex of either mesh its place on the other one's surface.
// In: a match and the two meshes. Non-rigid ICP (Amberg et al. 2007) that begins at the match's warp.
#pragma once

#include <limits>
#include <vector>

#include "homolog/match/transfer.h"
#include "homolog/shape/mesh.h"

namespace homolog {

/// Where a vertex lies on the other mesh.
struct DensePlace {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t triangle = none;    ///< of the other mesh, its number in Mesh::triangles
  Vec3 barycentric = Vec3::Zero();  ///< shares of its three corners, 0 to 1, sum 1
  Vec3 position = Vec3::Zero();     ///< in the other mesh's coordinates
  double confidence = 0;            ///< that it is right within .05 of the matched extent, if the match is right; 0 to 1

  bool is_there() const { return triangle != none; }
};

struct DenseMap {
  std::vector<DensePlace> places;  ///< of every vertex
  std::size_t placed = 0;          ///< how many of them are there
  std::size_t torn = 0;            ///< edges whose ends came to lie far apart along the other surface: one end of each lost its place
  std::size_t triangles = 0;       ///< with three places
  std::size_t folded = 0;          ///< of these, those that lie there with the wrong side up
};

struct DenseMaps {
  DenseMap data_from_model;         ///< of the model's vertices, on the data
  DenseMap model_from_data;         ///< of the data's vertices, on the model
  std::vector<Vec3> laid_vertices;  ///< the model's, in the data's coordinates: at their places, smoothly continued where they have none
};

/// The model's mesh is warped, then drawn onto the data: each vertex towards the nearest place that faces the same way (60 degrees), by
/// a skin that keeps its shape as far as it can (elastic_skin.h), in two steps, the second one finer. The data's vertices then find their
/// places on the model as it lies there, in the same way. Corners of folded triangles are drawn between their neighbours, at most by 2 % of
/// the extent (unfold.h). Without a place stay what lies outside the covered part, what is farther than 5 %
/// of the matched extent from the other surface, and one end of each edge whose ends would land farther apart along the skin than four
/// times its length at the match's scale and 2 % of the extent: so near limbs are never joined. Throws ShapeError for meshes
/// that check_mesh() refuses.
DenseMaps dense_maps(const MatchMap& match, const Mesh& model, const Mesh& data);

/// The chance that a place is right within .05 of the matched extent when its error is expected to be `expected` (transfer.h), in
/// extents: 1 / (1 + (expected / .05)^1.5), for half of the true errors are below the expected one and .84 below three times it.
double chance_within_reach(double expected);

}  // namespace homolog
