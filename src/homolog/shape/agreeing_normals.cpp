// SPDX-License-Identifier: MIT
#include "homolog/shape/agreeing_normals.h"

#include <utility>

#include "homolog/base/parallel.h"
#include "homolog/shape/nearest_points.h"

namespace homolog {
namespace {

constexpr std::size_t neighbours = 24;
constexpr std::size_t least_voters = 3;
constexpr double same_way = 0.5;  // a cosine: within 60 degrees
constexpr int rounds = 3;         // the first leaves those that have several like them near

bool is_overruled(std::size_t number, const PointCloud& cloud, const NearestPoints& tree) {
  std::size_t with = 0, against = 0;
  for (const auto& neighbour : tree.nearest(cloud.points[number], neighbours + 1)) {
    if (neighbour.number == number) continue;
    const double cosine = cloud.normals[neighbour.number].dot(cloud.normals[number]);
    with += cosine > same_way;
    against += cosine < -same_way;
  }
  return against >= least_voters && against >= overruled_by * with;
}

}  // namespace

void turn_overruled(PointCloud& cloud) {
  const NearestPoints tree(cloud.points);
  for (int round = 0; round < rounds; ++round) {
    std::vector<Vec3> turned = cloud.normals;
    parallel_for(turned.size(), [&](std::size_t i) {
      if (is_overruled(i, cloud, tree)) turned[i] = -turned[i];
    });
    cloud.normals = std::move(turned);
  }
}

}  // namespace homolog
