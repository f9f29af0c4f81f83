// SPDX-License-Identifier: MIT
// Beyond the paper: what a rig and shape keys do over time, carried with them.
#pragma once

#include "homolog/match/carry_rig.h"

namespace homolog {

/// The giver's animations for `rig`, which was carried from it (carry_rig.h). As the joints were carried with the surface about them, a
/// joint is turned in its parent as the giver's is, so that the receiver bends as the giver does, in whatever pose it was bound. With B and
/// B' the bind frames of a joint in its parent, s the scale of the best similarity of all places (times the size of the giver's parent),
/// and F the reversed x axis of a mirroring map (else F = 1), its pose in its parent is
///   turn' = F turn F, shift' = shift(B') + s F (shift - shift(B)), scale' = scale / scale(B).
/// A joint without a parent turns and moves from where it was bound: with M = turn(B') F turn(B)^-1, turn' = M turn F and
/// shift' = shift(B') + s M (shift - shift(B)). Weights of shape keys stay as they are.
std::vector<Animation> carry_animations(const AttributedMesh& giver, const Mesh& receiver, const GiverPlaces& on_giver, const Rig& rig);

}  // namespace homolog
