// SPDX-License-Identifier: MIT
#include "solids.h"

#include <fmt/format.h>

#include "fixtures/solids.h"
#include "random.h"

namespace homolog::bench {
namespace {

constexpr int mesh_resolution = 96;

fixtures::Solid random_piece(Random& random) {
  const auto vec = [&](double low, double high) {
    return Vec3(random.between(low, high), random.between(low, high), random.between(low, high));
  };
  const Vec3 place = vec(-0.6, 0.6);
  switch (static_cast<int>(random.between(0, 4))) {
    case 0:
      return fixtures::box(place, vec(0.08, 0.5));
    case 1:
      return fixtures::torus(place, random.direction(), random.between(0.3, 0.6), random.between(0.06, 0.15));
    case 2:
      return fixtures::capsule(place, place + random.between(0.3, 1) * random.direction(), random.between(0.06, 0.2));
    default:
      return fixtures::ellipsoid(place, vec(0.1, 0.5));
  }
}

}  // namespace

std::vector<NamedMesh> example_meshes() {
  return {{"hand", mesh_of(fixtures::hand(), mesh_resolution)},
          {"biplane", mesh_of(fixtures::biplane(), mesh_resolution)},
          {"quadruped", mesh_of(fixtures::quadruped(), mesh_resolution)}};
}

std::vector<NamedMesh> strangers(int count) {
  std::vector<NamedMesh> meshes;
  for (int i = 0; i < count; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 1, "stranger");
    std::vector<fixtures::Solid> pieces;
    for (int piece = 0; piece < 5; ++piece) pieces.push_back(random_piece(random));
    meshes.push_back({fmt::format("heap{}", i + 1), mesh_of(fixtures::join(pieces), mesh_resolution)});
  }
  return meshes;
}

}  // namespace homolog::bench
