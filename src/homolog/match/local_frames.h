// SPDX-License-Identifier: MIT
// Beyond the paper: how the body turns and stretches about each of its nodes, from where the nodes' neighbours lie.
#pragma once

#include <vector>

#include "homolog/match/cloth.h"

namespace homolog {

/// Best local rotations, local scales half way between the measured ones and the cloth's, and stretches that go from the rest to the
/// measured ones by the share `give`: a limb may become longer without becoming thicker.
void fit_local_frames(Cloth& cloth, const Edges& edges, double give = usual_give);

}  // namespace homolog
