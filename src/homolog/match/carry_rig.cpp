// SPDX-License-Identifier: MIT
#include "homolog/match/carry_rig.h"

#include <algorithm>
#include <queue>

#include "homolog/base/parallel.h"
#include "homolog/match/local_similarity.h"

namespace homolog {
namespace {

constexpr double least_distance = 0.005;  // of a joint from the surface, in diagonals
constexpr double key_radius = 0.03;       // about a vertex, in diagonals
constexpr double key_fade = 0.05;

/// The influences at a place, at most `most`.
Influences influences_at(const AttributedMesh& giver, const DensePlace& place, std::size_t most) {
  std::vector<Influence> mixed;
  for (int k = 0; k < 3; ++k) {
    for (const Influence& influence : giver.rig.influences[giver.mesh.triangles[place.triangle][k]]) {
      mixed.push_back({influence.joint, influence.weight * static_cast<float>(place.barycentric[k])});
    }
  }
  return strongest_influences(std::move(mixed), most);
}

bool follows_something(const Influences& influences) { return influences[0].weight > 0; }

/// The vertex with a place nearest to x.
std::uint32_t nearest_of(const Mesh& mesh, const std::vector<DensePlace>& places, const Vec3& x) {
  std::uint32_t best = NearestPlaced::none;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    if (!places[i].is_there()) continue;
    if (best == NearestPlaced::none || (mesh.vertices[i] - x).squaredNorm() < (mesh.vertices[best] - x).squaredNorm()) best = i;
  }
  return best;
}

/// For vertices of pieces without any place, the nearest vertex of the others to the middle of the piece: it moves as a whole.
std::vector<std::uint32_t> leaders_of_bare_pieces(const Mesh& mesh, const std::vector<DensePlace>& places, const NearestPlaced& nearest) {
  const std::vector<std::vector<std::uint32_t>> neighbours = neighbours_of(mesh);
  std::vector<std::uint32_t> leader = nearest.vertex;
  std::vector<char> seen(leader.size(), false);
  for (std::uint32_t i = 0; i < leader.size(); ++i) {
    if (seen[i] || nearest.vertex[i] != NearestPlaced::none) continue;
    std::vector<std::uint32_t> piece{i};
    seen[i] = true;
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < piece.size(); ++k) {
      sum += mesh.vertices[piece[k]];
      for (const std::uint32_t next : neighbours[piece[k]]) {
        if (!seen[next]) piece.push_back(next);
        seen[next] = true;
      }
    }
    const std::uint32_t found = nearest_of(mesh, places, sum / static_cast<double>(piece.size()));
    for (const std::uint32_t j : piece) leader[j] = found;
  }
  return leader;
}

std::vector<Influences> carry_influences(const AttributedMesh& giver, const Mesh& receiver, const std::vector<DensePlace>& places) {
  std::vector<DensePlace> weighed = places;  // only where the giver has weights
  std::vector<Influences> influences(places.size());
  const std::size_t most = most_influences(giver.rig.influences);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].is_there()) influences[i] = influences_at(giver, places[i], most);
    if (!follows_something(influences[i])) weighed[i] = {};
  }
  const std::vector<std::uint32_t> leader = leaders_of_bare_pieces(receiver, weighed, nearest_placed(receiver, weighed));
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (leader[i] != NearestPlaced::none) influences[i] = influences[leader[i]];
  }
  return influences;
}

/// What joints are carried by.
struct Carrying {
  const Mesh& receiver;
  const std::vector<DensePlace>& places;
  const std::vector<Influences>& influences;
  std::vector<double> areas;
  double giver_diagonal;
  Chirality chirality;
};

double weight_of(const Influences& influences, int joint) {
  double sum = 0;
  for (const Influence& influence : influences) sum += influence.joint == joint ? influence.weight : 0;
  return sum;
}

/// The places that follow a joint, or, with its parent too, either.
std::vector<WeighedPair> pairs_that_follow(const Carrying& carrying, int joint, int parent) {
  std::vector<WeighedPair> pairs;
  for (std::size_t i = 0; i < carrying.places.size(); ++i) {
    if (!carrying.places[i].is_there()) continue;
    const double weight = weight_of(carrying.influences[i], joint) + (parent < 0 ? 0 : weight_of(carrying.influences[i], parent));
    if (weight > 0) pairs.push_back({carrying.places[i].position, carrying.receiver.vertices[i], carrying.areas[i] * weight * weight});
  }
  return pairs;
}

void weigh_by_distance(std::vector<WeighedPair>& pairs, const Vec3& x, double diagonal) {
  double least = std::numeric_limits<double>::infinity();
  for (const WeighedPair& pair : pairs) least = std::min(least, (pair.from - x).squaredNorm());
  least = std::max(least, least_distance * diagonal * least_distance * diagonal);
  for (WeighedPair& pair : pairs) {
    const double away = (pair.from - x).squaredNorm() + least;
    pair.weight /= away * away / (least * least);
  }
}

Mat4 carry_bind(const Carrying& carrying, const Rig& rig, int number) {
  const Joint& joint = rig.joints[static_cast<std::size_t>(number)];
  const Vec3 place = joint.bind.topRightCorner<3, 1>();
  std::vector<WeighedPair> about = pairs_that_follow(carrying, number, joint.parent), own = pairs_that_follow(carrying, number, -1);
  if (about.empty()) about = all_pairs(carrying.receiver, carrying.places);
  weigh_by_distance(about, place, carrying.giver_diagonal);
  const Similarity s = best_similarity(about, carrying.chirality);
  Mat3 turn = own.empty() ? s.rotation : best_similarity(own, carrying.chirality).rotation;
  turn *= nearest_turn(joint.bind.topLeftCorner<3, 3>(), Chirality::proper).rotation;
  if (carrying.chirality == Chirality::mirrored) turn.col(0) = -turn.col(0);
  Mat4 carried = Mat4::Identity();
  carried.topLeftCorner<3, 3>() = turn;
  carried.topRightCorner<3, 1>() = s(place);
  return carried;
}

Vec3 displacement_at(const AttributedMesh& giver, const ShapeKey& key, const DensePlace& place) {
  Vec3 displacement = Vec3::Zero();
  for (int k = 0; k < 3; ++k) displacement += place.barycentric[k] * key.displacements[giver.mesh.triangles[place.triangle][k]];
  return displacement;
}

}  // namespace

NearestPlaced nearest_placed(const Mesh& mesh, const std::vector<DensePlace>& places) {
  const std::vector<std::vector<std::uint32_t>> neighbours = neighbours_of(mesh);
  NearestPlaced nearest{std::vector<std::uint32_t>(places.size(), NearestPlaced::none), std::vector<double>(places.size(), 0)};
  using Reached = std::tuple<double, std::uint32_t, std::uint32_t>;  // how far, from which, to which
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> reached;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    if (places[i].is_there()) reached.push({0, i, i});
  }
  while (!reached.empty()) {
    const auto [distance, from, to] = reached.top();
    reached.pop();
    if (nearest.vertex[to] != NearestPlaced::none) continue;
    nearest.vertex[to] = from;
    nearest.distance[to] = distance;
    for (const std::uint32_t next : neighbours[to]) {
      if (nearest.vertex[next] != NearestPlaced::none) continue;
      reached.push({distance + (mesh.vertices[next] - mesh.vertices[to]).norm(), from, next});
    }
  }
  return nearest;
}

Rig carry_rig(const AttributedMesh& giver, const Mesh& receiver, const GiverPlaces& on_giver) {
  Rig rig{giver.rig.joints, carry_influences(giver, receiver, on_giver.places)};
  const Carrying carrying{receiver,          on_giver.places, rig.influences, vertex_areas(receiver), bounding_box(giver.mesh).diagonal(),
                          on_giver.chirality};
  parallel_for(rig.joints.size(), [&](std::size_t i) { rig.joints[i].bind = carry_bind(carrying, giver.rig, static_cast<int>(i)); });
  return rig;
}

std::vector<ShapeKey> carry_shape_keys(const AttributedMesh& giver, const Mesh& receiver, const GiverPlaces& on_giver) {
  if (giver.shape_keys.empty()) return {};
  const std::vector<DensePlace>& places = on_giver.places;
  const NearestPlaced nearest = nearest_placed(receiver, places);
  const double diagonal = bounding_box(receiver).diagonal();
  std::vector<ShapeKey> keys;
  std::vector<char> moves(places.size(), false);
  for (const ShapeKey& key : giver.shape_keys) {
    keys.push_back({key.name, key.weight, std::vector<Vec3>(places.size(), Vec3::Zero())});
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (places[i].is_there()) keys.back().displacements[i] = displacement_at(giver, key, places[i]);
      if (!keys.back().displacements[i].isZero()) moves[i] = true;
    }
  }
  const std::vector<Similarity> about = similarities_about(receiver, places, moves, key_radius * diagonal, on_giver.chirality);
  for (ShapeKey& key : keys) {
    for (std::size_t i = 0; i < places.size(); ++i) key.displacements[i] = about[i].scale * (about[i].rotation * key.displacements[i]);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (places[i].is_there() || nearest.vertex[i] == NearestPlaced::none) continue;
      key.displacements[i] = std::max(0.0, 1 - nearest.distance[i] / (key_fade * diagonal)) * key.displacements[nearest.vertex[i]];
    }
  }
  return keys;
}

}  // namespace homolog
