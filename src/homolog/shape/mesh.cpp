// SPDX-License-Identifier: MIT
#include "homolog/shape/mesh.h"

#include <fmt/format.h>

#include <limits>

#include "homolog/base/errors.h"

namespace homolog {

void check_mesh(const Mesh& mesh) {
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (corner >= mesh.vertices.size()) {
        throw ShapeError(fmt::format("a triangle names vertex {}, but there are {}", corner, mesh.vertices.size()));
      }
      if (!mesh.vertices[corner].allFinite()) throw ShapeError(fmt::format("a coordinate of vertex {} is not a finite number", corner));
    }
  }
}

Box bounding_box(const Mesh& mesh) {
  if (mesh.triangles.empty()) throw ShapeError("the mesh has no triangles");
  Box box;
  box.min.setConstant(std::numeric_limits<double>::infinity());
  box.max = -box.min;
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      box.min = box.min.cwiseMin(mesh.vertices[corner]);
      box.max = box.max.cwiseMax(mesh.vertices[corner]);
    }
  }
  return box;
}

}  // namespace homolog
