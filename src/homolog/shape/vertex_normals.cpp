// SPDX-License-Identifier: MIT
#include "homolog/shape/vertex_normals.h"

#include <Eigen/Geometry>
#include <cmath>

#include "homolog/shape/orient.h"
#include "homolog/shape/weld.h"

namespace homolog {

std::vector<Vec3> vertex_normals(const Mesh& mesh) { return oriented_normals({mesh.vertices, orient(mesh).triangles}); }

std::vector<Vec3> oriented_normals(const Mesh& mesh) {
  const std::vector<std::uint32_t> first = first_equal_vertex(mesh.vertices);
  std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const Vec3& corner = mesh.vertices[triangle[k]];
      const Vec3 a = mesh.vertices[triangle[(k + 1) % 3]] - corner, b = mesh.vertices[triangle[(k + 2) % 3]] - corner;
      const Vec3 cross = a.cross(b);
      const double length = cross.norm();
      if (length > 0) normals[first[triangle[k]]] += std::atan2(length, a.dot(b)) / length * cross;
    }
  }
  for (std::size_t i = 0; i < normals.size(); ++i) normals[i] = first[i] == i ? normals[i].normalized() : normals[first[i]];
  return normals;
}

}  // namespace homolog
