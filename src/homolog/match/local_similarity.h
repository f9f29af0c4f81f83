// SPDX-License-Identifier: MIT
// Beyond the paper: how a dense map moves, turns and scales what lies about a point.
#pragma once

#include <vector>

#include "homolog/match/best_similarity.h"
#include "homolog/match/dense.h"

namespace homolog {

/// What moves the giver's places to the receiver's vertices about each of these: the best similarity of the vertices around it along the
/// edges, at least twelve and those nearer than `radius`, of weight area / (distance^2 + radius^2)^2. Only for `wanted` vertices, and only
/// those with a place count; the others' are the identity.
std::vector<Similarity> similarities_about(const Mesh& receiver, const std::vector<DensePlace>& places, const std::vector<char>& wanted,
                                           double radius, Chirality chirality);

/// Every place and where it comes to lie, weighed by its share of the receiver's area.
std::vector<WeighedPair> all_pairs(const Mesh& receiver, const std::vector<DensePlace>& places);

/// For every vertex its share of the surface's area.
std::vector<double> vertex_areas(const Mesh& mesh);

/// Vertices that edges join; copies of a vertex in one place share their neighbours, and are neighbours.
std::vector<std::vector<std::uint32_t>> neighbours_of(const Mesh& mesh);

}  // namespace homolog
