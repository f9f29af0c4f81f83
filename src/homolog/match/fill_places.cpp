// SPDX-License-Identifier: MIT
#include "homolog/match/fill_places.h"

#include "homolog/base/parallel.h"
#include "homolog/shape/nearest_surface.h"
#include "homolog/shape/vertex_normals.h"

namespace homolog {

std::size_t fill_places(std::vector<DensePlace>& places, const Mesh& mesh, const Mesh& other, const MatchMap& match, Direction direction) {
  std::vector<std::size_t> bare;
  std::vector<Vec3> vertices;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].is_there()) continue;
    bare.push_back(i);
    vertices.push_back(mesh.vertices[i]);
  }
  const std::vector<CarriedPoint> carried = carry_points(match, vertices, direction);
  const NearestSurface surface(other, vertex_normals(other));
  parallel_for(bare.size(), [&](std::size_t k) {
    const auto place = surface.nearest(carried[k].position, Vec3::Zero(), std::numeric_limits<double>::infinity());
    if (place) places[bare[k]] = {place->triangle, place->barycentric, place->position, 0};
  });
  return bare.size();
}

}  // namespace homolog
