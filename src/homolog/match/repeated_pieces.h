// SPDX-License-Identifier: MIT
// Beyond the paper: a shape in several pieces against itself. Each piece is looked for in the whole, since laid all at once they may change
// places as they like: any two copies would make a symmetry. A match may bend; what is repeated is the same without.
#pragma once

#include <vector>

#include "homolog/describe/separate_surfaces.h"
#include "homolog/match/match.h"

namespace homolog {

/// How far from exact a similarity near `start` lays the samples of a piece, `diagonal` wide, onto the whole: root mean square distance of
/// either surface from the other where the piece lies, each along the other's normal and .1 at most, in diagonals of the laid piece.
double repetition_error(const Similarity& start, const std::vector<SurfaceSample>& piece, double diagonal, const Shape& whole);

/// Whether one similarity lays the pieces, all of them, each within .03 of its own diagonal: the match's own, or one near it.
/// `surfaces`: the samples of each (separate_surfaces()).
bool moves_all(const Match& match, const std::vector<std::vector<int>>& surfaces, const Shape& whole);

/// The odds of each match of a piece with the whole fall with the square of its repetition error, beyond .01.
void believe_exact(std::vector<Match>& matches, const Shape& piece, const Shape& whole);

/// Whether one of the matches of the whole says the same of the piece.
bool is_known(const Match& match, const Shape& piece, const std::vector<Match>& of_whole);

/// Marks the samples of the whole on which the piece comes to lie, if the match is rather right than not.
void mark_reached(const Match& match, const Shape& piece, const Shape& whole, std::vector<char>& reached);

/// Adds the matches of a piece with the whole to those of the whole, in the numbers of the whole's points and of its skin.
void add_matches(Family& family, Family of_piece, const Piece& piece, const Shape& whole);

/// The `most` that are believed most, in that order; of equals, the ones added first.
void keep_surest(Family& family, int most);

}  // namespace homolog
