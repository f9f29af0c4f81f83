// SPDX-License-Identifier: MIT
#include "homolog/describe/sample_blocks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "homolog/base/halve.h"
#include "homolog/base/widest_clone.h"

namespace homolog {
namespace {

using Order = std::vector<int>;

SampleBlock fill_block(Order::const_iterator first, Order::const_iterator last, const std::vector<SurfaceSample>& samples,
                       const std::vector<LimbPlace>& limb_places, const Vec3& middle, float far_away) {
  SampleBlock block;
  block.x = block.y = block.z = BlockFloats::Constant(far_away);
  block.nx = block.ny = block.nz = block.limb = block.out = BlockFloats::Zero();
  block.sample.fill(-1);
  const auto count = static_cast<int>(last - first);
  for (int k = 0; k < count; ++k) {
    const SurfaceSample& sample = samples[block.sample[k] = first[k]];
    const Eigen::Vector3f place = (sample.position - middle).cast<float>(), normal = sample.normal.cast<float>();
    block.x[k] = place.x(), block.y[k] = place.y(), block.z[k] = place.z();
    block.nx[k] = normal.x(), block.ny[k] = normal.y(), block.nz[k] = normal.z();
    if (!limb_places.empty()) block.limb[k] = limb_places[first[k]].limb, block.out[k] = limb_places[first[k]].out;
  }
  return block;
}

BlockBall ball_around(const SampleBlock& block, int count) {
  BlockBall ball;
  for (int k = 0; k < count; ++k) ball.centre += Eigen::Vector3f(block.x[k], block.y[k], block.z[k]) / static_cast<float>(count);
  ball.radius = std::sqrt(squared_distances(block, ball.centre).head(count).maxCoeff());
  return ball;
}

// Blocks are full but for the last one.
void split(Order::iterator first, Order::iterator last, const std::vector<Vec3>& places) {
  if (last - first <= block_size) return;
  const auto blocks = (last - first + block_size - 1) / block_size;
  const auto cut = first + (blocks + 1) / 2 * block_size;
  halve(first, cut, last, places);
  split(first, cut, places);
  split(cut, last, places);
}

// The squared distances of squared_distances(), and the least of them.
HOMOLOG_WIDEST_CLONE float find_squares(const SampleBlock& block, const Eigen::Vector3f& place, float* squares) {
  for (int k = 0; k < block_size; k += 8) {
    const EightFloats x = eight(block.x.data() + k) - place.x(), y = eight(block.y.data() + k) - place.y(),
                      z = eight(block.z.data() + k) - place.z();
    eight(squares + k) = x * x + y * y + z * z;
  }
  float least[8];
  eight(least) = eight(squares) < eight(squares + 8) ? eight(squares) : eight(squares + 8);
  for (int half = 4; half > 0; half /= 2) {
    for (int k = 0; k < half; ++k) least[k] = std::min(least[k], least[k + half]);
  }
  return least[0];
}

}  // namespace

std::vector<int> block_order(const std::vector<Vec3>& places) {
  Order order(places.size());
  std::iota(order.begin(), order.end(), 0);
  split(order.begin(), order.end(), places);
  return order;
}

SampleBlocks make_blocks(const std::vector<SurfaceSample>& samples, const Order& order, const std::vector<LimbPlace>& limb_places) {
  SampleBlocks blocks;
  const auto count = static_cast<double>(samples.size());
  for (const SurfaceSample& sample : samples) blocks.middle += sample.position / count;
  double farthest = 0;
  for (const SurfaceSample& sample : samples) farthest = std::max(farthest, (sample.position - blocks.middle).norm());
  const auto far_away = static_cast<float>(1e6 * farthest);
  for (auto first = order.begin(); first != order.end();) {
    const auto last = first + std::min<std::ptrdiff_t>(block_size, order.end() - first);
    blocks.blocks.push_back(fill_block(first, last, samples, limb_places, blocks.middle, far_away));
    blocks.balls.push_back(ball_around(blocks.blocks.back(), static_cast<int>(last - first)));
    first = last;
  }
  return blocks;
}

SampleBlocks make_blocks(const std::vector<SurfaceSample>& samples, const std::vector<LimbPlace>& limb_places) {
  return make_blocks(samples, block_order(positions_of(samples)), limb_places);
}

BlockFloats squared_distances(const SampleBlock& block, const Eigen::Vector3f& place) {
  return (block.x - place.x()).square() + (block.y - place.y()).square() + (block.z - place.z()).square();
}

NearestSample nearest_sample(const SampleBlocks& samples, const Vec3& place, double farthest) {
  const Eigen::Vector3f p = (place - samples.middle).cast<float>();
  auto within = static_cast<float>(farthest);
  float best = within * within;
  NearestSample nearest;
  float squares[block_size];
  for (std::size_t b = 0; b < samples.blocks.size(); ++b) {
    if (!may_reach(samples.balls[b], p, within)) continue;
    const SampleBlock& block = samples.blocks[b];
    const float square = find_squares(block, p, squares);
    if (square >= best) continue;
    best = square;
    within = std::sqrt(square);
    nearest = {block.sample[std::find(squares, squares + block_size, square) - squares], within};
  }
  return nearest;
}

}  // namespace homolog
