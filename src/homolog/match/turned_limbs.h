// SPDX-License-Identifier: MIT
// Beyond the paper: a limb that points elsewhere, like a tail that hangs here and is raised there, is out of reach for a cloth drawn to
// what lies near. Ends left over are paired by where their limbs leave the body, and such limbs are laid anew.
#pragma once

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"
#include "homolog/match/limbs.h"

namespace homolog {

/// Pairs of free ends, best first: the ways from either end to the ends together differ by much the same, so the limbs branch off at the
/// same place and may be of another length. None without ends together.
EndsTogether turned_ends(const EndsTogether& together, const Cloth& cloth, const Shape& model, const Shape& data);

}  // namespace homolog
