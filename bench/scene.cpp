// SPDX-License-Identifier: MIT
#include "scene.h"

#include <cmath>

#include "change_mesh.h"
#include "random.h"

namespace homolog::bench {
namespace {

struct Placed {
  Vec3 centre;
  double radius;
};

// Darts thrown into a slowly growing ball until one hits free room.
Vec3 free_place(const std::vector<Placed>& taken, double radius, Random& random) {
  double reach = 0;
  for (const Placed& p : taken) reach = std::max(reach, 0.5 * p.radius);
  for (;; reach *= 1.02) {
    const Vec3 centre = reach * random.unit() * random.direction();
    bool free = true;
    for (const Placed& p : taken) free &= (p.centre - centre).norm() > p.radius + radius;
    if (free) return centre;
  }
}

// Puts a mesh into the scene: the ball around its box free of all others.
void put(Scene& scene, const Mesh& mesh, double scale, std::vector<Placed>& taken, Random& random) {
  const Box box = bounding_box(mesh);
  const Vec3 middle = (box.min + box.max) / 2;
  double radius = 0;
  for (const Vec3& v : mesh.vertices) radius = std::max(radius, scale * (v - middle).norm());
  const Vec3 centre = free_place(taken, radius, random);
  const Mat3 rotation = random.rotation();
  const auto first = static_cast<std::uint32_t>(scene.mesh.vertices.size());
  for (const Vec3& v : mesh.vertices) scene.mesh.vertices.push_back(centre + scale * (rotation * (v - middle)));
  for (const auto& [a, b, c] : mesh.triangles) scene.mesh.triangles.push_back({first + a, first + b, first + c});
  taken.push_back({centre, radius});
}

}  // namespace

Scene make_scene(const Mesh& shape, const std::vector<Mesh>& clutter, const SceneOptions& options, std::uint64_t seed) {
  Random random(seed, "scene");
  Scene scene;
  std::vector<Placed> taken;
  const double size = bounding_box(shape).diagonal();
  for (int i = 0; i < options.copies; ++i) {
    const bool mirror = options.mirror && i % 2 == 1;
    Mesh copy = mirror ? mirrored(shape) : shape;
    if (options.bend_degrees > 0 && i > 0) copy = bent(copy, options.bend_degrees);
    scene.copies.push_back({scene.mesh.vertices.size(), mirror});
    const double exponent = options.copies > 1 ? 2.0 * i / (options.copies - 1) - 1 : 0;
    put(scene, copy, std::pow(options.largest_ratio, exponent), taken, random);
  }
  for (const Mesh& thing : clutter) put(scene, thing, 0.6 * size / bounding_box(thing).diagonal(), taken, random);
  return scene;
}

}  // namespace homolog::bench
