// SPDX-License-Identifier: MIT
#pragma once

#include "homolog/shape/mesh.h"

namespace homolog::bench {

/// Distance of a point to the nearest triangle of a mesh.
double surface_distance(const Mesh& mesh, const Vec3& x);

}  // namespace homolog::bench
