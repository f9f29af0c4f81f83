// SPDX-License-Identifier: MIT
// Outward normals at the vertices of a mesh.
#pragma once

#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

/// Unit normals, one for every vertex: the mean of the normals of its triangles weighed by their angles there, so that how a face is cut
/// into triangles does not matter (Thuermer & Wuethrich 1998). Triangles are oriented first (orient.h); vertices in one place share their
/// normal; a vertex without triangles has a zero one.
std::vector<Vec3> vertex_normals(const Mesh& mesh);

/// The same for triangles that are oriented already.
std::vector<Vec3> oriented_normals(const Mesh& mesh);

}  // namespace homolog
