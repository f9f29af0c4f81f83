// SPDX-License-Identifier: MIT
#include "repeated_points.h"

#include <algorithm>
#include <cmath>

#include "random.h"

namespace homolog::bench {

double repeated_share(const std::vector<SalientPoint>& reference, const std::vector<SalientPoint>& points, const Tolerance& tolerance) {
  if (reference.empty()) return 0;
  const auto is_found = [&](const SalientPoint& p) {
    return std::any_of(points.begin(), points.end(), [&](const SalientPoint& q) {
      return (p.position - q.position).norm() <= tolerance.place * p.radius && std::abs(q.radius / p.radius - 1) <= tolerance.scale;
    });
  };
  return static_cast<double>(std::count_if(reference.begin(), reference.end(), is_found)) / static_cast<double>(reference.size());
}

double chance_share(const std::vector<SalientPoint>& reference, const std::vector<SalientPoint>& points, const Interior& interior,
                    int draws, std::uint64_t seed, const Tolerance& tolerance) {
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < interior.values.size(); ++i) {
    if (interior.values[i] > 0.5f) inside.push_back(i);
  }
  if (inside.empty()) return 0;
  Random random(seed, "chance");
  const std::size_t nx = interior.frame.size[0], ny = interior.frame.size[1];
  double sum = 0;
  for (int draw = 0; draw < draws; ++draw) {
    std::vector<SalientPoint> placed = points;
    for (SalientPoint& p : placed) {
      const std::size_t i = inside[static_cast<std::size_t>(random.unit() * static_cast<double>(inside.size()))];
      p.position = interior.frame.world_from_voxel(
          Vec3(static_cast<double>(i % nx), static_cast<double>(i / nx % ny), static_cast<double>(i / nx / ny)));
    }
    sum += repeated_share(reference, placed, tolerance);
  }
  return sum / draws;
}

}  // namespace homolog::bench
