// SPDX-License-Identifier: MIT
#include "homolog/describe/farthest_points.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "homolog/base/halve.h"

namespace homolog {
namespace {

constexpr std::size_t block_size = 24;

// Halves the points across their longest side until they are few.
void split(const std::vector<Eigen::Vector3f>& points, std::vector<std::size_t>& order, std::size_t begin, std::size_t end,
           std::vector<std::size_t>& borders) {
  if (end - begin <= block_size) {
    borders.push_back(end);
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  halve(order.begin() + begin, order.begin() + middle, order.begin() + end, points);
  split(points, order, begin, middle, borders);
  split(points, order, middle, end, borders);
}

float squared_distance_to_box(const Eigen::Vector3f& x, const Eigen::Vector3f& low, const Eigen::Vector3f& high) {
  return (low - x).cwiseMax(x - high).cwiseMax(0).squaredNorm();
}

}  // namespace

FarthestPoints::FarthestPoints(const std::vector<Eigen::Vector3f>& points)
    : distances_(points.size(), std::numeric_limits<float>::infinity()), numbers_(points.size()), places_(points.size()) {
  std::iota(numbers_.begin(), numbers_.end(), 0);
  std::vector<std::size_t> borders{0};
  split(points, numbers_, 0, points.size(), borders);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points_.push_back(points[numbers_[i]]);
    places_[numbers_[i]] = i;
  }
  for (std::size_t b = 1; b < borders.size(); ++b) {
    Block block{borders[b - 1], borders[b], points_[borders[b - 1]], points_[borders[b - 1]], 0, 0};
    for (std::size_t i = block.begin; i < block.end; ++i) {
      block.low = block.low.cwiseMin(points_[i]);
      block.high = block.high.cwiseMax(points_[i]);
    }
    find_farthest(block);
    blocks_.push_back(block);
  }
}

void FarthestPoints::find_farthest(Block& block) const {
  block.farthest = -1;
  for (std::size_t i = block.begin; i < block.end; ++i) {
    if (distances_[i] < block.farthest || (distances_[i] == block.farthest && numbers_[i] > block.point)) continue;
    block.farthest = distances_[i];
    block.point = numbers_[i];
  }
}

void FarthestPoints::choose(std::size_t point) {
  const Eigen::Vector3f chosen = points_[places_[point]];
  for (Block& block : blocks_) {
    if (squared_distance_to_box(chosen, block.low, block.high) >= block.farthest) continue;
    for (std::size_t i = block.begin; i < block.end; ++i) distances_[i] = std::min(distances_[i], (points_[i] - chosen).squaredNorm());
    find_farthest(block);
  }
}

FarthestPoint FarthestPoints::farthest() const {
  const Block* best = &blocks_.front();
  for (const Block& block : blocks_) {
    if (block.farthest > best->farthest || (block.farthest == best->farthest && block.point < best->point)) best = &block;
  }
  return {best->point, best->farthest};
}

}  // namespace homolog
