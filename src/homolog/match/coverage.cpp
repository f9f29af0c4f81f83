// SPDX-License-Identifier: MIT
#include "homolog/match/coverage.h"

#include <algorithm>

#include "homolog/base/parallel.h"
#include "homolog/match/coarse_surface.h"
#include "homolog/match/evidence.h"
#include "homolog/match/local_map.h"
#include "homolog/shape/nearest_surface.h"

namespace homolog {
namespace {

constexpr std::size_t run = 128;   // vertices that follow each other are mostly neighbours: the last answer is a good guess
constexpr double cell_size = 0.5;  // voxels: at 1 the weights of vertices are off by twice as much

/// Places with their outward normals.
struct Places {
  std::vector<Vec3> positions, normals;
};

/// One side of all matches: its places in its own coordinates, and where the part in use lies.
struct Side {
  const Mesh& mesh;
  CoarseSurface surface;
  Places samples;
  GridFrame frame;              ///< of the voxels, half a voxel around what was described
  std::optional<Box> box = {};  ///< PartWeights::box

  Places vertices() const { return {surface.mesh.vertices, surface.normals}; }
};

/// One side of one match in the data's coordinates.
struct LaidSide {
  Places vertices, samples;
  NearestSurface surface;  ///< through the vertices
};

bool in_use(const Side& side, const Vec3& x) {
  const Vec3 v = side.frame.voxel_from_world(x);
  const auto& [nx, ny, nz] = side.frame.size;
  return (v.array() >= 0).all() && (v.array() <= Vec3(nx - 1, ny - 1, nz - 1).array()).all();
}

/// Parts are told by the file's axes, and so stand their grids.
std::optional<Box> box_of_part(const Side& side) {
  const std::vector<Vec3>& vertices = side.mesh.vertices;
  if (!side.frame.axes.isIdentity(0) || std::all_of(vertices.begin(), vertices.end(), [&](const Vec3& x) { return in_use(side, x); }))
    return {};
  const auto& [nx, ny, nz] = side.frame.size;
  return Box{side.frame.origin, side.frame.world_from_voxel(Vec3(nx - 1, ny - 1, nz - 1))};
}

Side make_side(const MeshedShape& meshed, std::size_t most_asked) {
  const GridFrame& frame = meshed.shape.interior.frame;
  Side side{meshed.mesh, coarse_surface(meshed.mesh, cell_size * frame.spacing, most_asked), {}, frame};
  side.samples.positions = positions_of(meshed.shape.surface);
  for (const SurfaceSample& s : meshed.shape.surface) side.samples.normals.push_back(s.normal);
  side.box = box_of_part(side);
  return side;
}

Places laid(const Places& places, const ThinPlateSpline& data_from_model) {
  Places result;
  for (const LocalMap& local : local_maps(data_from_model, places.positions)) {
    result.normals.push_back(mapped_normal(local.gradient, places.normals[result.positions.size()]));
    result.positions.push_back(local.position);
  }
  return result;
}

LaidSide at_home(const Side& side) { return {side.vertices(), side.samples, {side.surface.mesh, side.surface.normals}}; }

void lay(LaidSide& laid_side, const Side& side, const ThinPlateSpline& data_from_model) {
  laid_side.vertices = laid(side.vertices(), data_from_model);
  laid_side.samples = laid(side.samples, data_from_model);
  laid_side.surface.move(laid_side.vertices.positions, laid_side.vertices.normals);
}

/// What a match measures its distances by, in the data's unit.
struct Tolerance {
  double reach, voxel;
};

/// How surely `places`, whose home coordinates are `home` on `side`, lie on the other side's surface.
std::vector<float> weigh(const Places& places, const std::vector<Vec3>& home, const Side& side, const NearestSurface& other,
                         const Side& other_side, const Tolerance& tolerance) {
  std::vector<float> weights(places.positions.size(), 0);
  parallel_for((weights.size() + run - 1) / run, [&](std::size_t block) {
    std::uint32_t likely = 0;
    for (std::size_t i = run * block; i < std::min(weights.size(), run * (block + 1)); ++i) {
      if (!in_use(side, home[i])) continue;
      const Vec3 &x = places.positions[i], &normal = places.normals[i];
      const auto place = other.nearest(x, normal, 2.5 * tolerance.reach, likely);
      if (!place) continue;
      likely = place->triangle;
      if (!in_use(other_side, other.between(*place, other_side.surface.mesh.vertices))) continue;
      const double along = std::abs((place->position - x).dot(normal));
      const double beside = (place->position - x - (place->position - x).dot(normal) * normal).norm();
      weights[i] = static_cast<float>(fade(along / tolerance.reach, 1, 2) * fade(beside / (tolerance.voxel + along / 2), 0.5, 1.5));
    }
  });
  return weights;
}

/// What the mesh's own vertices weigh.
std::vector<float> vertex_weights(const Side& side, std::vector<float> weights) {
  weights = values_between(side.surface, std::move(weights));
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!in_use(side, side.mesh.vertices[i])) weights[i] = 0;
  }
  return weights;
}

PartWeights weigh_both(const LaidSide& laid_side, const Side& side, const LaidSide& other, const Side& other_side,
                       const Tolerance& tolerance) {
  return {vertex_weights(side, weigh(laid_side.vertices, side.surface.mesh.vertices, side, other.surface, other_side, tolerance)),
          weigh(laid_side.samples, side.samples.positions, side, other.surface, other_side, tolerance), side.box};
}

}  // namespace

double fade(double value, double full, double none) {
  const double share = std::clamp((none - value) / (none - full), 0.0, 1.0);
  return share * share * (3 - 2 * share);
}

std::vector<MatchParts> covered_parts(const MeshedShape& model, const MeshedShape& data, const std::vector<Match>& matches,
                                      std::size_t most_asked) {
  if (matches.empty()) return {};
  const Side model_side = make_side(model, most_asked), data_side = make_side(data, most_asked);
  const LaidSide laid_data = at_home(data_side);
  LaidSide laid_model = at_home(model_side);
  std::vector<MatchParts> parts;
  for (const Match& match : matches) {
    const double scale = match.similarity.scale;
    const Tolerance tolerance{reached_share * matched_extent(model.shape.diagonal, scale, data.shape.diagonal),
                              std::max(data_side.frame.spacing, scale * model_side.frame.spacing)};
    lay(laid_model, model_side, match.data_from_model);
    parts.push_back({weigh_both(laid_model, model_side, laid_data, data_side, tolerance),
                     weigh_both(laid_data, data_side, laid_model, model_side, tolerance)});
  }
  return parts;
}

}  // namespace homolog
