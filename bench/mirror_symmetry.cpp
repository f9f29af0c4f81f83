// SPDX-License-Identifier: MIT
#include "mirror_symmetry.h"

#include <cmath>
#include <limits>

namespace homolog::bench {
namespace {

constexpr double tolerance = 0.01;

struct Plane {
  int axis;
  double place;
};

int nearest(const std::vector<Vec3>& vertices, std::size_t count, const Vec3& x) {
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    const double d = (vertices[i] - x).squaredNorm();
    if (d < least) least = d, best = static_cast<int>(i);
  }
  return best;
}

Vec3 mirrored(Vec3 x, const Plane& plane) {
  x[plane.axis] = 2 * plane.place - x[plane.axis];
  return x;
}

// Root mean square distance of some mirrored vertices to the nearest vertex.
double asymmetry(const std::vector<Vec3>& vertices, std::size_t count, const Plane& plane) {
  const std::size_t step = std::max<std::size_t>(1, count / 500);
  double sum = 0, asked = 0;
  for (std::size_t i = 0; i < count; i += step, ++asked) {
    const Vec3 x = mirrored(vertices[i], plane);
    sum += (vertices[static_cast<std::size_t>(nearest(vertices, count, x))] - x).squaredNorm();
  }
  return std::sqrt(sum / asked);
}

}  // namespace

std::vector<int> mirror_symmetry(const std::vector<Vec3>& vertices, std::size_t count) {
  Vec3 low = vertices.front(), high = vertices.front();
  for (std::size_t i = 0; i < count; ++i) low = low.cwiseMin(vertices[i]), high = high.cwiseMax(vertices[i]);
  Plane best{0, 0};
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const Plane plane{axis, (low[axis] + high[axis]) / 2};
    const double value = asymmetry(vertices, count, plane);
    if (value < least) least = value, best = plane;
  }
  if (!(least <= tolerance * (high - low).norm())) return {};
  std::vector<int> swap(count);
  for (std::size_t i = 0; i < count; ++i) swap[i] = nearest(vertices, count, mirrored(vertices[i], best));
  return swap;
}

}  // namespace homolog::bench
