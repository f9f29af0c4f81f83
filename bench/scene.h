// SPDX-License-Identifier: MIT
// Scenes: several copies of one shape, at different sizes, turned, some mirrored or bent, among other things.
#pragma once

#include <cstdint>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog::bench {

struct Scene {
  Mesh mesh;
  struct Copy {
    std::size_t first_vertex;  ///< vertex i of the shape is vertex first_vertex + i of the scene
    bool mirrored;
  };
  std::vector<Copy> copies;
};

struct SceneOptions {
  int copies = 2;
  double largest_ratio = 1;  ///< sizes go from 1 / ratio to ratio
  bool mirror = false;       ///< every second copy is a mirror image
  double bend_degrees = 0;
};

/// Copies and clutter lie free of each other, in an order and at places drawn by the seed.
Scene make_scene(const Mesh& shape, const std::vector<Mesh>& clutter, const SceneOptions& options, std::uint64_t seed);

}  // namespace homolog::bench
