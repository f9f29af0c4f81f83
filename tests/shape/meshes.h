// SPDX-License-Identifier: MIT
// Meshes for the tests of this folder, made in code with known volumes, and what is measured on them.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

#include "homolog/shape/mesh.h"
#include "homolog/shape/volume.h"

namespace homolog::meshes {

/// The box from min to max: 8 vertices, 12 triangles; the last two are the face z = max.
inline Mesh box(const Vec3& min, const Vec3& max) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) mesh.vertices.emplace_back((i & 1 ? max : min).x(), (i & 2 ? max : min).y(), (i & 4 ? max : min).z());
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4}, {1, 3, 7}, {1, 7, 5},
                    {3, 2, 6}, {3, 6, 7}, {2, 0, 4}, {2, 4, 6}, {4, 5, 7}, {4, 7, 6}};
  return mesh;
}

/// A torus around z of rings x segments quads, each cut in two.
inline Mesh torus(double ring_radius, double tube_radius, std::uint32_t rings, std::uint32_t segments) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < rings; ++i) {
    for (std::uint32_t j = 0; j < segments; ++j) {
      const double a = 2 * M_PI * i / rings, b = 2 * M_PI * j / segments, out = ring_radius + tube_radius * std::cos(b);
      mesh.vertices.emplace_back(out * std::cos(a), out * std::sin(a), tube_radius * std::sin(b));
      const std::uint32_t i1 = (i + 1) % rings, j1 = (j + 1) % segments;
      mesh.triangles.push_back({i * segments + j, i1 * segments + j, i1 * segments + j1});
      mesh.triangles.push_back({i * segments + j, i1 * segments + j1, i * segments + j1});
    }
  }
  return mesh;
}

/// Triangles of the unit sphere split into four `levels` times.
inline Mesh split(Mesh mesh, int levels) {
  for (int level = 0; level < levels; ++level) {
    Mesh finer{mesh.vertices, {}};
    for (const auto& [a, b, c] : mesh.triangles) {
      const auto n = static_cast<std::uint32_t>(finer.vertices.size());
      finer.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
      finer.vertices.push_back((mesh.vertices[b] + mesh.vertices[c]).normalized());
      finer.vertices.push_back((mesh.vertices[c] + mesh.vertices[a]).normalized());
      finer.triangles.insert(finer.triangles.end(), {{a, n, n + 2}, {n, b, n + 1}, {n + 2, n + 1, c}, {n, n + 1, n + 2}});
    }
    mesh = finer;
  }
  return mesh;
}

/// An octahedron, split.
inline Mesh sphere(int levels) {
  return split({{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}},
               levels);
}

/// An icosahedron on the unit sphere: all angles are 60 degrees, and acute when it is split.
inline Mesh icosahedron() {
  Mesh mesh;
  const double golden = (1 + std::sqrt(5.0)) / 2;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-golden, golden}) mesh.vertices.insert(mesh.vertices.end(), {{0, a, b}, {a, b, 0}, {b, 0, a}});
  }
  const auto joined = [&](std::uint32_t i, std::uint32_t j) { return (mesh.vertices[i] - mesh.vertices[j]).norm() < 2.1; };
  for (std::uint32_t i = 0; i < 12; ++i) {
    for (std::uint32_t j = i + 1; j < 12; ++j) {
      for (std::uint32_t k = j + 1; k < 12; ++k) {
        if (!joined(i, j) || !joined(j, k) || !joined(k, i)) continue;
        const bool outwards = mesh.vertices[i].dot(mesh.vertices[j].cross(mesh.vertices[k])) > 0;
        mesh.triangles.push_back({i, outwards ? j : k, outwards ? k : j});
      }
    }
  }
  for (Vec3& vertex : mesh.vertices) vertex.normalize();
  return mesh;
}

inline Mesh joined(Mesh a, const Mesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [i, j, k] : b.triangles) a.triangles.push_back({i + offset, j + offset, k + offset});
  return a;
}

inline Mesh reversed(Mesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

inline Mesh moved(Mesh mesh, const Mat3& turn, const Vec3& shift = Vec3::Zero()) {
  for (Vec3& vertex : mesh.vertices) vertex = turn * vertex + shift;
  return mesh;
}

inline double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) sum += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c])) / 6;
  return sum;
}

inline double volume(const Interior& interior) {
  return std::accumulate(interior.values.begin(), interior.values.end(), 0.0) * std::pow(interior.frame.spacing, 3);
}

}  // namespace homolog::meshes
