// SPDX-License-Identifier: MIT
// Eight triangles at once, and the place of each that is nearest to a point: as nearest_on_triangle() finds it, but for rounding.
#pragma once

#include <array>

#include "homolog/shape/mesh.h"

namespace homolog {

inline constexpr int triangles_at_once = 8;

/// A number for each of eight triangles.
using EightNumbers = std::array<double, triangles_at_once>;

struct EightTriangles {
  std::array<std::array<EightNumbers, 3>, 3> corners;  ///< [corner][axis]
};

struct EightPlaces {
  std::array<EightNumbers, 3> barycentric;  ///< [corner]
  EightNumbers square_distance;
};

EightPlaces nearest_places(const EightTriangles& triangles, const Vec3& x);

}  // namespace homolog
