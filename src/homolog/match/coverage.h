// SPDX-License-Identifier: MIT
// Beyond the paper: which region of either surface a match covers. The one home of this weight: files, reports and transfer read it here.
#pragma once

#include <optional>
#include <vector>

#include "homolog/describe/shape.h"
#include "homolog/match/match.h"
#include "homolog/shape/mesh.h"

namespace homolog {

/// A mesh as read, and the shape described from it or from a part of it.
struct MeshedShape {
  const Mesh& mesh;
  const Shape& shape;
};

/// How surely places of one surface lie in the part that a match covers: 1 inside, 0 outside, between at its border.
struct PartWeights {
  std::vector<float> vertices;  ///< of the mesh
  std::vector<float> samples;   ///< of Shape::surface, which knows nothing of the tessellation
  std::optional<Box> box;       ///< where what was described lies, if that is but a part of the mesh: outside it all weighs 0
};

struct MatchParts {
  PartWeights model, data;
};

/// The parts of every match. A place is covered as far as the other surface, with the model's one warped, lies near along the place's
/// normal (within 2 % of the matched extent), beside it by no more than a voxel and half that distance (so that nothing counts beyond
/// the border of a part), and faces the same way (60 degrees). What lies outside the box of a part that was described weighs 0. A mesh of
/// more than `most_asked` vertices is asked at clusters of them, half a voxel wide, and its vertices get what is between those.
std::vector<MatchParts> covered_parts(const MeshedShape& model, const MeshedShape& data, const std::vector<Match>& matches,
                                      std::size_t most_asked = 200000);

/// 1 up to `full`, 0 from `none` on, smooth between.
double fade(double value, double full, double none);

}  // namespace homolog
