// SPDX-License-Identifier: MIT
// Symmetries as sentences and as JSON.
#pragma once

#include <string>
#include <vector>

#include "homolog/match/symmetry.h"

namespace homolog {

/// "mirrored in the plane 1.0000 x +0.0000 y +0.0000 z = 0.5; it lies within 0.02 % of the diagonal (root mean square)" and the like.
std::string symmetry_sentence(const Symmetry& symmetry);

/// These after their ranks, a line each.
std::string symmetries_text(const std::vector<Symmetry>& symmetries);

/// `symmetry.json`, format "homolog-symmetry" version 1: "symmetries": [...] in the order of the family: {"kind": "mirrored", "normal",
/// "offset", "error"}, the plane normal . x = offset, or
/// {"kind": "repeated", "mirrored", "scale", "axis", "degrees", "shift", "error"}, y = scale turn(axis, degrees) x + shift, where x is
/// negated along the first axis before if "mirrored" is true.
std::string symmetries_json(const std::vector<Symmetry>& symmetries);

/// These from that text, for the same matches, which tell how what is repeated moves. `file` names it in errors. Throws FileError.
std::vector<Symmetry> read_symmetries(const std::string& text, const std::string& file, const std::vector<Match>& matches);

}  // namespace homolog
