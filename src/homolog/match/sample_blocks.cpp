// SPDX-License-Identifier: MIT
#include "homolog/match/sample_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace homolog {
namespace {

using Order = std::vector<int>;

SampleBlock fill_block(Order::const_iterator first, Order::const_iterator last, const std::vector<Vec3>& places,
                       const std::vector<Vec3>& normals, const Vec3& middle) {
  constexpr float far_away = 1e15f;  // its square is still finite
  SampleBlock block;
  block.x = block.y = block.z = BlockFloats::Constant(far_away);
  block.nx = block.ny = block.nz = BlockFloats::Zero();
  block.sample.fill(-1);
  block.centre.setZero();
  const auto count = static_cast<int>(last - first);
  for (int k = 0; k < count; ++k) {
    const int sample = block.sample[k] = first[k];
    const Eigen::Vector3f place = (places[sample] - middle).cast<float>(), normal = normals[sample].cast<float>();
    block.x[k] = place.x(), block.y[k] = place.y(), block.z[k] = place.z();
    block.nx[k] = normal.x(), block.ny[k] = normal.y(), block.nz[k] = normal.z();
    block.centre += place / static_cast<float>(count);
  }
  block.radius = std::sqrt(squared_distances(block, block.centre).head(count).maxCoeff());
  return block;
}

void split(Order::iterator first, Order::iterator last, const std::vector<Vec3>& places, const std::vector<Vec3>& normals,
           SampleBlocks& into) {
  if (last - first <= block_size) {
    into.blocks.push_back(fill_block(first, last, places, normals, into.middle));
    return;
  }
  Vec3 low = places[*first], high = low;
  for (auto it = first; it != last; ++it) low = low.cwiseMin(places[*it]), high = high.cwiseMax(places[*it]);
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const auto blocks = (last - first + block_size - 1) / block_size;
  const auto cut = first + (blocks + 1) / 2 * block_size;  // whole blocks to the left, so that only the last one is not full
  std::nth_element(first, cut, last,
                   [&](int a, int b) { return places[a][axis] != places[b][axis] ? places[a][axis] < places[b][axis] : a < b; });
  split(first, cut, places, normals, into);
  split(cut, last, places, normals, into);
}

}  // namespace

SampleBlocks make_blocks(const std::vector<Vec3>& places, const std::vector<Vec3>& normals) {
  SampleBlocks samples;
  if (places.empty()) return samples;
  for (const Vec3& place : places) samples.middle += place / static_cast<double>(places.size());
  Order order(places.size());
  std::iota(order.begin(), order.end(), 0);
  split(order.begin(), order.end(), places, normals, samples);
  return samples;
}

BlockFloats squared_distances(const SampleBlock& block, const Eigen::Vector3f& place) {
  return (block.x - place.x()).square() + (block.y - place.y()).square() + (block.z - place.z()).square();
}

NearestSample nearest_sample(const SampleBlocks& samples, const Vec3& place) {
  const Eigen::Vector3f p = (place - samples.middle).cast<float>();
  float best = std::numeric_limits<float>::infinity(), within = best;
  NearestSample nearest;
  for (const SampleBlock& block : samples.blocks) {
    const float passed = within + block.radius;
    if ((block.centre - p).squaredNorm() > passed * passed) continue;
    int k = 0;
    const float square = squared_distances(block, p).minCoeff(&k);
    if (square >= best) continue;
    best = square;
    within = std::sqrt(square);
    nearest = {block.sample[k], within};
  }
  return nearest;
}

}  // namespace homolog
