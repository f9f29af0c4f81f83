// SPDX-License-Identifier: MIT
// A ball, the same bent, turned and three times as large, and a match of the two that is right at a few places alone.
#pragma once

#include <functional>

#include "fixtures/solids.h"
#include "homolog/match/transfer.h"
#include "shape/meshes.h"

namespace homolog::bent_ball {

inline Vec3 bend(const Vec3& x) {
  return 3 * (fixtures::random_rotation(7) * Vec3(x.x(), x.y() + 0.3 * x.x() * x.x(), x.z())) + Vec3(5, 1, -20);
}

inline Vec3 mirrored_bend(const Vec3& x) { return bend(fixtures::mirror_x() * x); }

inline Mesh moved(Mesh mesh, const std::function<Vec3(const Vec3&)>& map) {
  for (Vec3& vertex : mesh.vertices) vertex = map(vertex);
  return mesh;
}

/// The warp through a few places of the cube from -1 to 1, so that it is right at these alone.
inline MatchMap match_by(const std::function<Vec3(const Vec3&)>& map, Chirality chirality = Chirality::proper) {
  std::vector<Vec3> sources, targets;
  for (int i = 0; i < 27; ++i) {
    sources.emplace_back(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    targets.push_back(map(sources.back()));
  }
  MatchMap match;
  match.data_from_model = ThinPlateSpline::similarity_free(SourceSystem(sources, std::vector<double>(27, 0)), targets, chirality);
  match.scale = match.data_from_model.similarity.scale;
  match.model_diagonal = 2 * std::sqrt(3.0);
  match.data_diagonal = 3 * match.model_diagonal;
  for (const Vec3& source : sources) match.known.push_back({source, 0.95});
  return match;
}

/// A ball, and a bent one with other triangles.
inline const Mesh ball = meshes::sphere(4), bent = moved(meshes::moved(meshes::sphere(4), fixtures::random_rotation(3)), bend);

}  // namespace homolog::bent_ball
