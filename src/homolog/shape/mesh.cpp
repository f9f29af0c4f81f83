// SPDX-License-Identifier: MIT
#include "homolog/shape/mesh.h"

#include <limits>

#include "homolog/base/errors.h"

namespace homolog {

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
