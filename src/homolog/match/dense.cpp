// SPDX-License-Identifier: MIT
#include "homolog/match/dense.h"

#include <cmath>
#include <functional>

#include "homolog/base/parallel.h"
#include "homolog/match/dense_faults.h"
#include "homolog/match/elastic_skin.h"
#include "homolog/match/unfold.h"
#include "homolog/shape/orient.h"
#include "homolog/shape/vertex_normals.h"

namespace homolog {
namespace {

// Lengths in matched extents.
constexpr double drag_lengths[] = {0.04, 0.01};  // how far a vertex drags others along, step by step
constexpr double reach = 0.05;                   // how far a vertex may be drawn
constexpr double sure_reach = 0.02;              // up to which it has its whole say
constexpr double most_stretch = 4;               // of an edge, beyond the scale of the match, before it counts as torn
constexpr double slack = 0.02;                   // how far apart the ends of any edge may lie
constexpr double good_error = 0.05;
constexpr double unfolding = 0.02;  // how far a vertex may be moved to unfold triangles

/// A mesh to be drawn onto another, in that one's coordinates, and how surely its vertices belong to the covered part.
struct Drawn {
  const Mesh& mesh;
  const Mesh& outer;  ///< the same, its triangles oriented
  std::vector<Vec3> positions, normals;
  std::vector<double> coverage;
};

/// What it is drawn onto: the surface where it lies, and the same at rest, along which ways are measured.
struct Ground {
  NearestSurface surface;
  const Mesh& at_rest;
  const std::vector<Vec3>& outward;  ///< normals of its vertices at rest
  SkinRoutes routes;
  TearLimit limit;
};

struct Laid {
  std::vector<Vec3> positions;
  Places places;  ///< positions on the ground at rest
  std::size_t torn = 0;
};

/// `likely`: places of the same vertices before, where the search begins.
Places nearest_places(const std::vector<Vec3>& positions, const Drawn& drawn, const Ground& ground, double extent, const Places& likely) {
  Places places(positions.size());
  parallel_for(positions.size(), [&](std::size_t i) {
    if (drawn.coverage[i] < 0.5) return;
    places[i] = ground.surface.nearest(positions[i], drawn.normals[i], reach * extent, likely[i] ? likely[i]->triangle : 0);
  });
  return places;
}

Places at_rest(Places places, const Ground& ground) {
  for (auto& place : places) {
    if (place) place->position = ground.surface.between(*place, ground.at_rest.vertices);
  }
  return places;
}

/// What draws the vertices to their places, as strongly as those are sure; torn ones are left alone.
VertexPull pull_to(const Drawn& drawn, const Places& places, const Places& untorn, double extent) {
  VertexPull pull{drawn.positions, std::vector<double>(places.size(), 0)};
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!untorn[i]) continue;
    pull.targets[i] = places[i]->position;
    pull.weights[i] = drawn.coverage[i] * fade(places[i]->distance / extent, sure_reach, reach);
  }
  return pull;
}

/// `mirrored`: the map turns right-handed into left-handed.
Laid lay(const Drawn& drawn, const Ground& ground, const ElasticSkin& skin, double extent, bool mirrored) {
  const auto edges = edges_of(drawn.mesh);
  Laid laid{drawn.positions, {}};
  Places places(drawn.positions.size());
  for (const double length : drag_lengths) {
    places = nearest_places(laid.positions, drawn, ground, extent, places);
    Places untorn = at_rest(places, ground);
    take_torn_apart(untorn, drawn.mesh, edges, ground.routes, ground.limit);
    laid.positions = skin.drawn(laid.positions, pull_to(drawn, places, untorn, extent), length * extent);
  }
  places = nearest_places(laid.positions, drawn, ground, extent, places);
  unfold(places, {drawn.outer, drawn.normals, ground.surface, ground.at_rest, ground.outward, mirrored}, unfolding * extent);
  laid.places = at_rest(places, ground);
  laid.torn = take_torn_apart(laid.places, drawn.mesh, edges, ground.routes, ground.limit);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (laid.places[i]) laid.positions[i] = places[i]->position;
  }
  return laid;
}

/// Outward normals of a mesh whose triangles were oriented before a map, perhaps a mirrored one, moved its vertices.
std::vector<Vec3> moved_normals(const std::vector<Vec3>& positions, const Mesh& oriented, bool mirrored) {
  std::vector<Vec3> normals = oriented_normals({positions, oriented.triangles});
  if (!mirrored) return normals;
  for (Vec3& normal : normals) normal = -normal;
  return normals;
}

std::vector<double> coverage_of(const CoveredSamples& samples, double diagonal, const std::vector<Vec3>& vertices) {
  std::vector<double> coverage(vertices.size(), 1);
  if (samples.positions.empty()) return coverage;
  parallel_for(vertices.size(), [&](std::size_t i) { coverage[i] = coverage_at(samples, diagonal, vertices[i]); });
  return coverage;
}

/// `expected`: the error of each vertex as a share of the extent, for those that have a place.
DenseMap dense_map(const Laid& laid, const Drawn& drawn, const Folds& folds, const std::function<double(std::size_t)>& expected) {
  DenseMap map{std::vector<DensePlace>(laid.places.size()), 0, laid.torn, folds.triangles, folds.folded};
  for (std::size_t i = 0; i < laid.places.size(); ++i) {
    if (!laid.places[i]) continue;
    const SurfacePlace& place = *laid.places[i];
    map.places[i] = {place.triangle, place.barycentric, place.position, drawn.coverage[i] * chance_within_reach(expected(i))};
    ++map.placed;
  }
  return map;
}

}  // namespace

double chance_within_reach(double expected) { return 1 / (1 + std::pow(expected / good_error, 1.5)); }

DenseMaps dense_maps(const MatchMap& match, const Mesh& model, const Mesh& data) {
  check_mesh(model);
  check_mesh(data);
  const double extent = matched_extent(match.model_diagonal, match.scale, match.data_diagonal);
  const Chirality chirality = chirality_of(match);
  const bool mirrored = chirality == Chirality::mirrored;
  const Mesh outer_model{model.vertices, orient(model).triangles}, outer_data{data.vertices, orient(data).triangles};
  const std::vector<Vec3> model_normals = oriented_normals(outer_model), data_normals = oriented_normals(outer_data);
  const std::vector<CarriedPoint> carried = carry_points(match, model.vertices, Direction::data_from_model);
  Drawn on_data{model, outer_model, {}, {}, {}};
  for (const CarriedPoint& vertex : carried) {
    on_data.positions.push_back(vertex.position);
    on_data.coverage.push_back(vertex.coverage.value_or(1));
  }
  on_data.normals = moved_normals(on_data.positions, outer_model, mirrored);
  const Ground data_ground{{data, data_normals}, data, data_normals, SkinRoutes(data), {most_stretch * match.scale, slack * extent}};
  const Laid laid_model = lay(on_data, data_ground, ElasticSkin(model, match.scale, chirality), extent, mirrored);

  const Drawn on_model{data, outer_data, data.vertices, data_normals, coverage_of(match.data, match.data_diagonal, data.vertices)};
  const Ground model_ground{{{laid_model.positions, model.triangles}, moved_normals(laid_model.positions, outer_model, mirrored)},
                            model,
                            model_normals,
                            SkinRoutes(model),
                            {most_stretch / match.scale, slack * extent / match.scale}};
  const Laid laid_data = lay(on_model, model_ground, ElasticSkin(data, 1, Chirality::proper), extent, mirrored);

  const auto model_error = [&](std::size_t i) { return carried[i].expected_error / extent; };
  const auto data_error = [&](std::size_t i) {
    const SurfacePlace& place = *laid_data.places[i];
    double error = 0;
    for (int k = 0; k < 3; ++k) error += place.barycentric[k] * model_error(model.triangles[place.triangle][k]);
    return error;
  };
  return {dense_map(laid_model, on_data, count_folds(outer_model.triangles, laid_model.places, data, data_normals, mirrored), model_error),
          dense_map(laid_data, on_model, count_folds(outer_data.triangles, laid_data.places, model, model_normals, mirrored), data_error),
          laid_model.positions};
}

}  // namespace homolog
