// SPDX-License-Identifier: MIT
// Beyond the paper: what a match of a shape with itself says in a few numbers: a mirror plane, or how a part is repeated.
#pragma once

#include <optional>

#include "homolog/match/best_similarity.h"
#include "homolog/match/coverage.h"

namespace homolog {

/// The plane normal . x = offset, in the unit of the shape.
struct Plane {
  Vec3 normal = Vec3::UnitX();  ///< of unit length
  double offset = 0;
};

/// x reflected in a plane: x - 2 (normal . x - offset) normal.
Vec3 reflected(const Plane& plane, const Vec3& x);

/// The plane whose reflection R minimises sum w |R(from) - to|^2: its normal is the eigenvector of the least eigenvalue of the symmetric
/// part of sum w (from - mean)(to - mean)^T, and it passes through the mean of all midpoints.
Plane best_mirror_plane(const std::vector<WeighedPair>& pairs);

/// How a shape is laid onto itself.
struct Symmetry {
  std::optional<Plane> mirror;  ///< of a match that mirrors a part in place
  Similarity movement;          ///< how a part of any other comes to lie on its repetition, which may be its mirror image: the match's own
  double error = 0;             ///< how exact: root of the mean square distance from the surface at which the part lies then, in diagonals
};

/// The symmetry of every match of a shape with itself; `parts` of the same matches (covered_parts()). A plane is first the best one of the
/// match's map on the covered part (weights by area and cover), then of the nearest places of the surface to what it reflects, twenty
/// times. So a bent shape has a plane, too, with an error that tells that it is bent. There is none where the match's map lays the part
/// farther from the first plane's reflection, in the mean, than the part's radius (root mean square): on another copy.
std::vector<Symmetry> symmetries_of(const MeshedShape& shape, const std::vector<Match>& matches, const std::vector<MatchParts>& parts);

}  // namespace homolog
