// SPDX-License-Identifier: MIT
// Beyond the paper: places for the vertices that a dense map leaves without one, as artists want them rather than holes.
#pragma once

#include "homolog/match/dense.h"

namespace homolog {

/// Gives every vertex without a place the one on the other mesh that is nearest to where the match's map lays it; its confidence stays 0.
/// `direction`: from the mesh of the vertices to the other one. Returns how many there were.
std::size_t fill_places(std::vector<DensePlace>& places, const Mesh& mesh, const Mesh& other, const MatchMap& match, Direction direction);

}  // namespace homolog
