// SPDX-License-Identifier: MIT
// Parts of a closed mesh, cut by a plane and closed again.
#pragma once

#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog::bench {

struct CutPart {
  Mesh mesh;
  std::vector<int> whole_vertex;  ///< number in the whole of the part's first vertices; the later ones are new, on the cut
};

/// Volume of a closed mesh, outward oriented.
double volume_of(const Mesh& mesh);

/// Does every edge of a triangle have one that runs back along it? Vertices go by their numbers, as the cut has them.
bool is_closed(const Mesh& mesh);

/// The part where x . normal > offset. The cut is closed by a fan about one point, right by winding number for any outline.
CutPart cut(const Mesh& whole, const Vec3& normal, double offset);

/// The part at the end that `normal` points to, with the given share of the volume (0 to 1).
CutPart cut_share(const Mesh& whole, const Vec3& normal, double share);

}  // namespace homolog::bench
