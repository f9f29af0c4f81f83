// SPDX-License-Identifier: MIT
// The model turning into the data: one mesh with a morph target and an animation, as glTF 2.0, or frame by frame.
#pragma once

#include <string>
#include <vector>

#include "homolog/match/dense.h"
#include "homolog/outputs/ply.h"

namespace homolog {

/// One mesh in two shapes, both in the data's coordinates.
struct Morph {
  Mesh start;             ///< the model, laid over the data by a similarity
  std::vector<Vec3> end;  ///< its vertices on the data
};

/// The model laid over the data by the similarity of the match, and by its dense map; its triangles turned over if these mirror.
Morph make_morph(const MatchMap& match, const Mesh& model, const DenseMaps& maps);

/// The mesh at `share` of the way, 0 the start and 1 the end; vertices go straight.
Mesh frame_of(const Morph& morph, double share);

/// Binary glTF 2.0: a mesh with normals, colours (unless there are none), one morph target and an animation of its weight, 0 to 1 and back
/// in four seconds. Vertices keep their order; positions are relative to the middle of the start's box, where the node stands, so that
/// single precision is enough. The file keeps the data's axes and unit, although glTF means metres and y up.
std::string morph_glb(const Morph& morph, const std::vector<Colour>& colours);

}  // namespace homolog
