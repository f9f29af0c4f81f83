// SPDX-License-Identifier: MIT
#include "homolog/match/local_similarity.h"

#include <unordered_set>

#include "homolog/base/parallel.h"
#include "homolog/match/dense_faults.h"
#include "homolog/shape/weld.h"

namespace homolog {
namespace {

constexpr std::size_t fewest = 12;  // pairs that a similarity is fitted to

/// What of the surface around vertex i has a place, weighed.
std::vector<WeighedPair> pairs_around(std::uint32_t i, const Mesh& receiver, const std::vector<DensePlace>& places,
                                      const std::vector<std::vector<std::uint32_t>>& neighbours, const std::vector<double>& areas,
                                      double radius) {
  std::vector<WeighedPair> pairs;
  std::vector<std::uint32_t> reached{i};
  std::unordered_set<std::uint32_t> seen{i};
  for (std::size_t k = 0; k < reached.size(); ++k) {
    const std::uint32_t j = reached[k];
    const double square = (receiver.vertices[j] - receiver.vertices[i]).squaredNorm();
    if (square > radius * radius && pairs.size() >= fewest) continue;
    const double away = square + radius * radius;
    if (places[j].is_there()) pairs.push_back({places[j].position, receiver.vertices[j], areas[j] / (away * away)});
    for (const std::uint32_t next : neighbours[j]) {
      if (seen.insert(next).second) reached.push_back(next);
    }
  }
  return pairs;
}

}  // namespace

std::vector<Similarity> similarities_about(const Mesh& receiver, const std::vector<DensePlace>& places, const std::vector<char>& wanted,
                                           double radius, Chirality chirality) {
  const std::vector<std::vector<std::uint32_t>> neighbours = neighbours_of(receiver);
  const std::vector<double> areas = vertex_areas(receiver);
  std::vector<Similarity> similarities(places.size());
  parallel_for(places.size(), [&](std::size_t i) {
    if (!wanted[i]) return;
    similarities[i] = best_similarity(pairs_around(static_cast<std::uint32_t>(i), receiver, places, neighbours, areas, radius), chirality);
  });
  return similarities;
}

std::vector<WeighedPair> all_pairs(const Mesh& receiver, const std::vector<DensePlace>& places) {
  const std::vector<double> areas = vertex_areas(receiver);
  std::vector<WeighedPair> pairs;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].is_there()) pairs.push_back({places[i].position, receiver.vertices[i], areas[i]});
  }
  return pairs;
}

std::vector<double> vertex_areas(const Mesh& mesh) {
  std::vector<double> areas(mesh.vertices.size(), 0);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 ab = mesh.vertices[b] - mesh.vertices[a], ac = mesh.vertices[c] - mesh.vertices[a];
    for (const std::uint32_t corner : {a, b, c}) areas[corner] += ab.cross(ac).norm() / 6;
  }
  return areas;
}

std::vector<std::vector<std::uint32_t>> neighbours_of(const Mesh& mesh) {
  const std::vector<std::uint32_t> first = first_equal_vertex(mesh.vertices);
  std::vector<std::vector<std::uint32_t>> neighbours(mesh.vertices.size());
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  };
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    if (first[i] != i) join(i, first[i]);
  }
  for (const auto& [a, b] : edges_of(mesh)) join(a, b);
  return neighbours;
}

}  // namespace homolog
