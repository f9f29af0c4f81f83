// SPDX-License-Identifier: MIT
#include "homolog/match/carry_texturing.h"

#include <algorithm>
#include <map>
#include <optional>

#include "homolog/base/parallel.h"
#include "homolog/shape/nearest_surface.h"
#include "homolog/shape/vertex_normals.h"
#include "homolog/shape/weld.h"

namespace homolog {
namespace {

constexpr double detour = 1.25;  // how far a way may lead around the straight one between its ends

/// A side of a triangle: its vertices, the UVs there, the material.
struct Side {
  std::array<std::uint32_t, 2> vertices;
  std::array<Uv, 2> uvs;
  int material;
  std::uint32_t triangle;
  int number;
};

Side side_of(const AttributedMesh& mesh, const std::vector<std::uint32_t>& first, std::uint32_t triangle, int k) {
  const int l = (k + 1) % 3;
  const auto& corners = mesh.mesh.triangles[triangle];
  const auto& uvs = mesh.texturing.corners[triangle];
  const auto uv = [&](int corner) { return uvs[corner] == Texturing::no_uv ? Uv{} : mesh.texturing.uvs[uvs[corner]]; };
  const bool forwards = first[corners[k]] < first[corners[l]];
  const int a = forwards ? k : l, b = forwards ? l : k;
  return {{first[corners[a]], first[corners[b]]}, {uv(a), uv(b)}, mesh.texturing.material_of[triangle], triangle, k};
}

/// A triangle of the giver and the UVs of the places on it.
struct Islands {
  const AttributedMesh& giver;
  IslandNeighbours neighbours;
  NearestSurface surface;
  std::vector<Vec3> normals;
};

SurfacePlace nearest_place(const Mesh& mesh, std::uint32_t triangle, const Vec3& x) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  SurfacePlace place;
  place.triangle = triangle;
  place.barycentric = nearest_on_triangle(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], x);
  place.position =
      place.barycentric[0] * mesh.vertices[a] + place.barycentric[1] * mesh.vertices[b] + place.barycentric[2] * mesh.vertices[c];
  place.distance = (place.position - x).norm();
  return place;
}

/// The place itself if its triangle can be reached from `start`, which lies at `from`, without crossing a seam or going far around; else
/// the nearest one that can.
SurfacePlace reached_place(const Islands& islands, std::uint32_t start, const Vec3& from, const DensePlace& place) {
  const Mesh& mesh = islands.giver.mesh;
  const Vec3& x = place.position;
  const SurfacePlace itself{place.triangle, place.barycentric, x, 0};
  if (start == place.triangle) return itself;
  const Vec3 middle = (from + x) / 2;
  const double reach = detour * (x - from).norm() / 2;
  std::vector<std::uint32_t> seen{start};
  SurfacePlace best = nearest_place(mesh, start, x);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (const std::uint32_t next : islands.neighbours.beyond[seen[i]]) {
      if (next == IslandNeighbours::none || std::find(seen.begin(), seen.end(), next) != seen.end()) continue;
      if (nearest_place(mesh, next, middle).distance > reach) continue;
      if (next == place.triangle) return itself;
      seen.push_back(next);
      const SurfacePlace near = nearest_place(mesh, next, x);
      if (near.distance < best.distance) best = near;
    }
  }
  return best;
}

/// The place on the giver nearest to the middle of three.
std::optional<SurfacePlace> middle_place(const Islands& islands, const std::array<const DensePlace*, 3>& places) {
  Vec3 middle = Vec3::Zero(), normal = Vec3::Zero();
  double reach = 0;
  for (const DensePlace* place : places) middle += place->position / 3;
  for (const DensePlace* place : places) {
    reach = std::max(reach, 1.01 * (place->position - middle).norm());
    const auto& triangle = islands.giver.mesh.triangles[place->triangle];
    for (int k = 0; k < 3; ++k) normal += place->barycentric[k] * islands.normals[triangle[k]];
  }
  if (reach == 0) return nearest_place(islands.giver.mesh, places[0]->triangle, middle);
  const auto agreeing = islands.surface.nearest(middle, normal, reach, places[0]->triangle);
  return agreeing ? agreeing : islands.surface.nearest(middle, Vec3::Zero(), reach, places[0]->triangle);
}

Uv uv_at(const Texturing& texturing, const SurfacePlace& place) {
  Uv uv{};
  for (int k = 0; k < 3; ++k) {
    const Uv& corner = texturing.uvs[texturing.corners[place.triangle][k]];
    for (int axis = 0; axis < 2; ++axis) uv[axis] += place.barycentric[k] * corner[axis];
  }
  return uv;
}

struct Carried {
  int material = -1;
  std::optional<std::array<Uv, 3>> uvs;
};

Carried carry_triangle(const Islands& islands, const Triangle& triangle, const std::vector<DensePlace>& places) {
  const std::array<const DensePlace*, 3> corners{&places[triangle[0]], &places[triangle[1]], &places[triangle[2]]};
  for (const DensePlace* corner : corners) {
    if (!corner->is_there()) return {};
  }
  const std::optional<SurfacePlace> middle = middle_place(islands, corners);
  if (!middle) return {};
  const Texturing& texturing = islands.giver.texturing;
  Carried carried{texturing.material_of[middle->triangle], {}};
  if (!texturing.has_uvs(middle->triangle)) return carried;
  carried.uvs.emplace();
  for (int k = 0; k < 3; ++k) {
    (*carried.uvs)[k] = uv_at(texturing, reached_place(islands, middle->triangle, middle->position, *corners[k]));
  }
  return carried;
}

}  // namespace

IslandNeighbours island_neighbours(const AttributedMesh& mesh) {
  const std::vector<std::uint32_t> first = first_equal_vertex(mesh.mesh.vertices);
  std::map<std::array<std::uint32_t, 2>, std::vector<Side>> sides;
  for (std::uint32_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Side side = side_of(mesh, first, t, k);
      sides[side.vertices].push_back(side);
    }
  }
  constexpr std::array<std::uint32_t, 3> alone{IslandNeighbours::none, IslandNeighbours::none, IslandNeighbours::none};
  IslandNeighbours neighbours{std::vector<std::array<std::uint32_t, 3>>(mesh.mesh.triangles.size(), alone)};
  for (const auto& [vertices, shared] : sides) {
    for (const Side& side : shared) {
      for (const Side& other : shared) {
        const bool joined = other.triangle != side.triangle && other.uvs == side.uvs && other.material == side.material &&
                            mesh.texturing.has_uvs(other.triangle) == mesh.texturing.has_uvs(side.triangle);
        if (joined) neighbours.beyond[side.triangle][side.number] = other.triangle;
      }
    }
  }
  return neighbours;
}

Texturing carry_texturing(const AttributedMesh& giver, const Mesh& receiver, const std::vector<DensePlace>& places) {
  const std::vector<Vec3> normals = vertex_normals(giver.mesh);
  const Islands islands{giver, island_neighbours(giver), {giver.mesh, normals}, normals};
  std::vector<Carried> carried(receiver.triangles.size());
  parallel_for(carried.size(), [&](std::size_t t) { carried[t] = carry_triangle(islands, receiver.triangles[t], places); });

  Texturing texturing;
  texturing.materials = giver.texturing.materials;
  texturing.images = giver.texturing.images;
  texturing.gltf = giver.texturing.gltf;
  std::map<std::pair<std::uint32_t, Uv>, std::uint32_t> numbers;  // a vertex has one UV on either side of a seam
  for (std::size_t t = 0; t < carried.size(); ++t) {
    texturing.material_of.push_back(carried[t].material);
    texturing.corners.push_back({Texturing::no_uv, Texturing::no_uv, Texturing::no_uv});
    for (int k = 0; k < 3 && carried[t].uvs; ++k) {
      const Uv& uv = (*carried[t].uvs)[k];
      const auto [number, is_new] = numbers.try_emplace({receiver.triangles[t][k], uv}, static_cast<std::uint32_t>(texturing.uvs.size()));
      if (is_new) texturing.uvs.push_back(uv);
      texturing.corners.back()[k] = number->second;
    }
  }
  return texturing;
}

}  // namespace homolog
