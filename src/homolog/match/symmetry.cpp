// SPDX-License-Identifier: MIT
#include "homolog/match/symmetry.h"

#include <Eigen/Eigenvalues>

#include "homolog/base/parallel.h"
#include "homolog/match/local_similarity.h"
#include "homolog/shape/nearest_surface.h"
#include "homolog/shape/vertex_normals.h"

namespace homolog {
namespace {

constexpr int refinements = 20;
constexpr std::size_t most_places = 4000;  // of the surface, which are looked at

/// The shape's surface, and what is asked of it.
struct Surface {
  NearestSurface nearest;
  std::vector<Vec3> normals;
  std::vector<double> areas;
};

/// The places of a covered part, with what they weigh.
struct Part {
  std::vector<std::uint32_t> vertices;
  std::vector<double> weights;
};

Part part_of(const Surface& surface, const std::vector<float>& cover) {
  const std::size_t step = surface.areas.size() / most_places + 1;
  Part part;
  for (std::uint32_t i = 0; i < surface.areas.size(); i += static_cast<std::uint32_t>(step)) {
    if (!(cover[i] > 0)) continue;
    part.vertices.push_back(i);
    part.weights.push_back(cover[i] * surface.areas[i]);
  }
  return part;
}

/// The places of the part that a reflection lays near the surface, and where on it they come to lie.
std::vector<WeighedPair> reflected_pairs(const Surface& surface, const Part& part, const Plane& plane) {
  std::vector<WeighedPair> pairs(part.vertices.size(), {Vec3::Zero(), Vec3::Zero(), 0});
  parallel_for(pairs.size(), [&](std::size_t i) {
    const Vec3& x = surface.nearest.mesh().vertices[part.vertices[i]];
    const Vec3 normal = reflected({plane.normal, 0}, surface.normals[part.vertices[i]]);
    const auto place = surface.nearest.nearest(reflected(plane, x), normal, std::numeric_limits<double>::infinity());
    if (place) pairs[i] = {x, place->position, part.weights[i]};
  });
  return pairs;
}

// Does the plane lay the places about where the map does, beside how far they spread?
bool is_in_place(const Plane& plane, const std::vector<WeighedPair>& pairs) {
  const Vec3 middle = means_of(pairs).from;
  double missed = 0, spread = 0;
  for (const WeighedPair& pair : pairs) {
    missed += pair.weight * (reflected(plane, pair.from) - pair.to).squaredNorm();
    spread += pair.weight * (pair.from - middle).squaredNorm();
  }
  return missed < spread;
}

std::optional<Plane> mirror_plane(const Surface& surface, const Part& part, const Match& match) {
  std::vector<WeighedPair> pairs;
  for (std::size_t i = 0; i < part.vertices.size(); ++i) {
    const Vec3& x = surface.nearest.mesh().vertices[part.vertices[i]];
    pairs.push_back({x, match.data_from_model(x), part.weights[i]});
  }
  Plane plane = best_mirror_plane(pairs);
  if (!is_in_place(plane, pairs)) return {};
  for (int k = 0; k < refinements; ++k) plane = best_mirror_plane(reflected_pairs(surface, part, plane));
  return plane;
}

/// The distance of the moved part from the surface, by its root mean square.
template <class Movement>
double distance_of(const Surface& surface, const Part& part, const Movement& move) {
  std::vector<double> squares(part.vertices.size(), 0);
  parallel_for(squares.size(), [&](std::size_t i) {
    const Vec3 moved = move(surface.nearest.mesh().vertices[part.vertices[i]]);
    const auto place = surface.nearest.nearest(moved, Vec3::Zero(), std::numeric_limits<double>::infinity());
    if (place) squares[i] = place->distance * place->distance;
  });
  double sum = 0, weight = 0;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    sum += part.weights[i] * squares[i];
    weight += part.weights[i];
  }
  return weight > 0 ? std::sqrt(sum / weight) : 0;
}

Symmetry symmetry_of(const Surface& surface, const Part& part, const Match& match) {
  Symmetry symmetry;
  symmetry.movement = match.similarity;
  if (match.similarity.rotation.determinant() < 0) symmetry.mirror = mirror_plane(surface, part, match);
  symmetry.error = symmetry.mirror ? distance_of(surface, part, [&](const Vec3& x) { return reflected(*symmetry.mirror, x); })
                                   : distance_of(surface, part, match.similarity);
  return symmetry;
}

}  // namespace

Vec3 reflected(const Plane& plane, const Vec3& x) { return x - 2 * (plane.normal.dot(x) - plane.offset) * plane.normal; }

Plane best_mirror_plane(const std::vector<WeighedPair>& pairs) {
  const auto [a, b, sum] = means_of(pairs);
  if (!(sum > 0)) return {};
  Mat3 products = Mat3::Zero();
  for (const WeighedPair& pair : pairs) products += pair.weight * (pair.from - a) * (pair.to - b).transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(products + products.transpose());
  Plane plane{solver.eigenvectors().col(0), 0};
  Eigen::Index largest = 0;
  plane.normal.cwiseAbs().maxCoeff(&largest);
  if (plane.normal[largest] < 0) plane.normal = -plane.normal;  // one of both, always the same
  plane.offset = plane.normal.dot(a + b) / 2;
  return plane;
}

std::vector<Symmetry> symmetries_of(const MeshedShape& shape, const std::vector<Match>& matches, const std::vector<MatchParts>& parts) {
  const std::vector<Vec3> normals = vertex_normals(shape.mesh);
  const Surface surface{{shape.mesh, normals}, normals, vertex_areas(shape.mesh)};
  std::vector<Symmetry> symmetries;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    symmetries.push_back(symmetry_of(surface, part_of(surface, parts[i].model.vertices), matches[i]));
    symmetries.back().error /= shape.shape.diagonal;
  }
  return symmetries;
}

}  // namespace homolog
