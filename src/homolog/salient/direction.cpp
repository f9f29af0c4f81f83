// SPDX-License-Identifier: MIT
// Sec. 4.3, eq. 2 and 3: p from the centre of mass of the inside around a salient point.
#include "homolog/salient/direction.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "homolog/base/parallel.h"

namespace homolog {
namespace {

// Large balls are sampled at every n-th voxel, so that their radius is about this many samples.
constexpr int kSamplesAcrossRadius = 16;

// Mean(B(radius, x) cap O) - x, in voxels; x and radius in voxels. Voxels that the ball's border cuts count in part.
Vec3 mean_offset(const Interior& interior, const Vec3& x, double radius) {
  const int step = std::max(1, static_cast<int>(radius / kSamplesAcrossRadius));
  std::array<int, 3> low{}, high{};
  for (int a = 0; a < 3; ++a) {
    low[a] = std::max(0, static_cast<int>(std::ceil((x[a] - radius - step) / step)) * step);
    high[a] = std::min(interior.frame.size[a] - 1, static_cast<int>(std::floor(x[a] + radius + step)));
  }
  double mass = 0;
  Vec3 moment = Vec3::Zero();
  for (int k = low[2]; k <= high[2]; k += step) {
    for (int j = low[1]; j <= high[1]; j += step) {
      for (int i = low[0]; i <= high[0]; i += step) {
        const Vec3 offset = Vec3(i, j, k) - x;
        const double weight = interior.at(i, j, k) * std::clamp((radius - offset.norm()) / step + 0.5, 0.0, 1.0);
        mass += weight;
        moment += weight * offset;
      }
    }
  }
  return mass > 0 ? Vec3(moment / mass) : Vec3(Vec3::Zero());
}

}  // namespace

void find_directions(const Interior& interior, const SalientParams& params, std::vector<SalientPoint>& points) {
  parallel_for(points.size(), [&](std::size_t n) {
    SalientPoint& point = points[n];
    const double r = point.radius / interior.frame.spacing;
    const Vec3 offset = mean_offset(interior, interior.frame.voxel_from_world(point.position), params.direction_radius * r);
    const Vec3 away = interior.frame.axes * -offset;
    if (away.norm() > 0) point.direction = away.normalized();  // eq. 3
    point.direction_length = away.norm() / r < params.direction_min ? 0 : away.norm() / r;
  });
}

}  // namespace homolog
