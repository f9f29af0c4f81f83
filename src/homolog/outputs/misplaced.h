// SPDX-License-Identifier: MIT
// Meshes and points that are given to a match found before: whether they lie where its shapes lay. Programs turn and scale what they save
// (Blender's PLY is Z up, its glTF Y up), and what is looked up in the wrong place comes out wrong without a word.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "homolog/match/transfer.h"
#include "homolog/shape/mesh.h"

namespace homolog {

/// One shape of a match as it lay when it was matched.
struct MatchedShape {
  std::string name;
  const CoveredSamples& samples;  ///< empty: not known; then nothing is misplaced
  double diagonal;
  double thickness = 0;  ///< MatchMap::thickness
};

/// The shape that `direction` carries from.
MatchedShape carried_from(const MatchMap& match, Direction direction, const std::string& name);

struct Misplaced {
  std::string sentence;    ///< what is wrong, why if that is known, and what to do
  bool explained = false;  ///< turned or scaled as the sentence says it would lie right
};

/// None where three quarters of the shape lie on the mesh, or three quarters of the mesh on the shape: so that parts of the shape, more
/// than was matched of it and other tessellations are welcome. Shapes with another axis up share half of their surface at most; but those
/// that look alike before and behind can stand turned about unnoticed.
std::optional<Misplaced> misplaced(const Mesh& mesh, const std::string& file, const MatchedShape& shape);

/// What to ask about points most of which are farther from the shape than a tenth of its diagonal, where they begin not to belong to it, or
/// of which several lie in one place of it, as in another unit they would; else nothing.
std::string misplaced_points(const std::vector<Vec3>& points, const std::string& file, const MatchedShape& shape);

}  // namespace homolog
