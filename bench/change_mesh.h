// SPDX-License-Identifier: MIT
// Changes of a closed mesh whose truth is exact: vertex i stays vertex i, except where said. Lengths are shares of the bounding box.
#pragma once

#include <cstdint>

#include "homolog/shape/mesh.h"

namespace homolog::bench {

/// Bent about a circle by so many degrees from end to end of the longest axis.
Mesh bent(const Mesh& mesh, double degrees);

/// Twisted about the longest axis by so many degrees from end to end.
Mesh twisted(const Mesh& mesh, double degrees);

/// All beyond `from` (0 to 1) of the longest axis grows along it by a factor.
Mesh lengthened(const Mesh& mesh, double from, double factor);

/// Grows across the longest axis, from factor 1 at one end to `factor` at the other.
Mesh fattened(const Mesh& mesh, double factor);

/// Its mirror image, outward again.
Mesh mirrored(const Mesh& mesh);

/// Every vertex moved by normal noise with this deviation, in shares of the diagonal.
Mesh noisy(const Mesh& mesh, double deviation, std::uint64_t seed);

/// Coarser: vertices in one cell of a grid (so many cells along the longest axis) become one. Numbers change; places do not.
Mesh clustered(const Mesh& mesh, int cells);

}  // namespace homolog::bench
