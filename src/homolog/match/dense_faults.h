// SPDX-License-Identifier: MIT
// What can be wrong with a dense map: edges torn apart, triangles folded over.
#pragma once

#include <optional>
#include <vector>

#include "homolog/match/skin_routes.h"

namespace homolog {

/// A place for every vertex of a mesh on another one, or none.
using Places = std::vector<std::optional<SurfacePlace>>;

/// Pairs of vertices that a triangle joins, each once.
std::vector<std::array<std::uint32_t, 2>> edges_of(const Mesh& mesh);

/// How far apart along the other surface the ends of an edge may come to lie: stretch * its length + slack.
struct TearLimit {
  double stretch, slack;
};

/// Takes the place of one end of every torn edge away, of the one with more torn edges; returns how many edges were torn.
std::size_t take_torn_apart(Places& places, const Mesh& mesh, const std::vector<std::array<std::uint32_t, 2>>& edges,
                            const SkinRoutes& other, const TearLimit& limit);

struct Folds {
  std::size_t triangles, folded;
};

/// Triangles of a consistently oriented mesh with three places, and how many of them lie with the wrong side up where those are.
/// `normals`: outward, of the other mesh's vertices; `mirrored`: the map turns right-handed into left-handed.
Folds count_folds(const std::vector<Triangle>& triangles, const Places& places, const Mesh& other, const std::vector<Vec3>& normals,
                  bool mirrored);

}  // namespace homolog
