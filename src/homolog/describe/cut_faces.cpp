// SPDX-License-Identifier: MIT
#include "homolog/describe/cut_faces.h"

#include <algorithm>
#include <limits>

namespace homolog {
namespace {

constexpr double least_depth = 0.6;   // r: a plane so far from the centre takes 10 % of a ball, nearer ones more
constexpr double face_thickness = 2;  // voxels

// Distance to the nearest face that cuts through the whole; faces on the whole's own box cut nothing.
double distance_to_cut(const Vec3& x, const Box& part, const Box& whole) {
  double nearest = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 3; ++a) {
    if (part.min[a] > whole.min[a]) nearest = std::min(nearest, std::abs(x[a] - part.min[a]));
    if (part.max[a] < whole.max[a]) nearest = std::min(nearest, std::abs(x[a] - part.max[a]));
  }
  return nearest;
}

}  // namespace

void forget_cut_faces(const Box& part, const Box& whole, double spacing, std::vector<SalientPoint>& points,
                      std::vector<SurfaceSample>& surface) {
  std::erase_if(points, [&](const SalientPoint& p) { return distance_to_cut(p.position, part, whole) < least_depth * p.radius; });
  std::erase_if(surface, [&](const SurfaceSample& s) { return distance_to_cut(s.position, part, whole) < face_thickness * spacing; });
}

}  // namespace homolog
