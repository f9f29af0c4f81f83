// SPDX-License-Identifier: MIT
// One closed mesh in the other forms in which people have it, all in its coordinates.
#pragma once

#include <string>
#include <vector>

#include "generate.h"

namespace homolog::bench {

/// The surface of its coverage at 256 voxels: other vertices, evenly drawn.
Mesh remeshed(const Mesh& mesh);

/// Remeshed, coarsened to 5 % of its triangles by clustering, a soup (every triangle with its own corners, 10 % missing, 30 % turned),
/// another without holes whose corners are moved by 1e-9 of the diagonal, the surfaces of label volumes of 128 and 256 voxels along the
/// longest side, and those of clouds of 5 000, 50 000 and 500 000 points drawn evenly from the surface, once with noise of a thousandth
/// of the diagonal.
std::vector<NamedMesh> other_forms(const Mesh& mesh);

}  // namespace homolog::bench
