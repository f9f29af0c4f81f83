// SPDX-License-Identifier: MIT
// Beyond the paper: triangles that a dense map lays with the wrong side up are drawn flat.
#pragma once

#include "homolog/match/dense_faults.h"

namespace homolog {

/// A mesh on a surface: its oriented triangles and what its vertices face where they lie; the surface there and at rest, where folds are
/// seen, with the outward normals of its vertices. `mirrored`: the map turns right-handed into left-handed.
struct LaidMesh {
  const Mesh& mesh;
  const std::vector<Vec3>& facing;
  const NearestSurface& surface;
  const Mesh& at_rest;
  const std::vector<Vec3>& outward;
  bool mirrored;
};

/// Draws corners of folded triangles towards the mean of their neighbours and back onto the surface, one after the other, wherever less is
/// folded then about them; none farther than `farthest` from where it was.
void unfold(Places& places, const LaidMesh& laid, double farthest);

}  // namespace homolog
