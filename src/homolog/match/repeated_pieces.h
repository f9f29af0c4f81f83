// SPDX-License-Identifier: MIT
// Beyond the paper: a shape in several pieces against itself. Each piece is looked for in the whole, since laid all at once they may change
// places as they like: any two copies would make a symmetry.
#pragma once

#include <vector>

#include "homolog/describe/separate_surfaces.h"
#include "homolog/match/match.h"

namespace homolog {

/// Whether one similarity tells where the shape goes: the match covers half of it, and differs from its own similarity by less than .05
/// of the diagonal in the mean.
bool is_one_movement(const Match& match, const Shape& shape);

/// Marks the samples of the whole on which the piece comes to lie, if the match is rather right than not.
void mark_reached(const Match& match, const Shape& piece, const Shape& whole, std::vector<char>& reached);

/// Adds the matches of a piece with the whole to those of the whole, in the numbers of the whole's points and of its skin.
void add_matches(Family& family, Family of_piece, const Piece& piece, const Shape& whole);

/// The `most` that are believed most, in that order; of equals, the ones added first.
void keep_surest(Family& family, int most);

}  // namespace homolog
