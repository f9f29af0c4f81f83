// SPDX-License-Identifier: MIT
// A coarser mesh by clustering vertices in the cells of a grid (Rossignac and Borrel 1993): quick for millions of triangles, and any mesh
// will do.
#pragma once

#include <cstdint>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

struct ClusteredMesh {
  static constexpr std::uint32_t nowhere = 0xffffffff;
  Mesh mesh;
  std::vector<std::uint32_t> cluster;  ///< of every vertex of the mesh itself; nowhere for one that no triangle uses
};

/// All vertices in a cell become their mean; triangles that collapse are left out. With `normals`, one a vertex, only those join that face
/// the same of six ways, so that the two sides of a plate stay apart. `cell` at least a millionth of the mesh's diagonal.
ClusteredMesh cluster_vertices(const Mesh& mesh, double cell, const std::vector<Vec3>& normals = {});

}  // namespace homolog
