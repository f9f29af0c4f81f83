// SPDX-License-Identifier: MIT
#include "homolog/shape/nearest_points.h"

#include <algorithm>
#include <numeric>

#include "homolog/base/halve.h"

namespace homolog {
namespace {

constexpr std::uint32_t leaf_size = 8;

}  // namespace

NearestPoints::NearestPoints(std::vector<Vec3> points) : points_(std::move(points)) {
  order_.resize(points_.size());
  std::iota(order_.begin(), order_.end(), 0u);
  if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

std::uint32_t NearestPoints::build(std::uint32_t first, std::uint32_t end) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  Box box{points_[order_[first]], points_[order_[first]]};
  for (std::uint32_t i = first; i < end; ++i) {
    box.min = box.min.cwiseMin(points_[order_[i]]);
    box.max = box.max.cwiseMax(points_[order_[i]]);
  }
  nodes_.push_back({box, first, end - first});
  if (end - first <= leaf_size) return number;
  const std::uint32_t half = first + (end - first) / 2;
  halve(order_.begin() + first, order_.begin() + half, order_.begin() + end, points_);
  build(first, half);
  const std::uint32_t second = build(half, end);
  nodes_[number].first = second;
  nodes_[number].count = 0;
  return number;
}

/// The heap has the farthest of the nearest on top.
void NearestPoints::look(std::uint32_t number, const Vec3& x, std::size_t count, std::vector<Neighbour>& heap) const {
  const Node& node = nodes_[number];
  if (heap.size() == count && square_distance(node.box, x) > heap.front().square_distance) return;
  if (node.count == 0) {
    const bool swapped = square_distance(nodes_[node.first].box, x) < square_distance(nodes_[number + 1].box, x);
    look(swapped ? node.first : number + 1, x, count, heap);
    look(swapped ? number + 1 : node.first, x, count, heap);
    return;
  }
  for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
    const Neighbour neighbour{(points_[order_[i]] - x).squaredNorm(), order_[i]};
    if (heap.size() == count) {
      if (!(neighbour < heap.front())) continue;
      std::pop_heap(heap.begin(), heap.end());
      heap.pop_back();
    }
    heap.push_back(neighbour);
    std::push_heap(heap.begin(), heap.end());
  }
}

std::vector<NearestPoints::Neighbour> NearestPoints::nearest(const Vec3& x, std::size_t count) const {
  std::vector<Neighbour> heap;
  if (nodes_.empty() || count == 0) return heap;
  heap.reserve(count + 1);
  look(0, x, count, heap);
  std::sort_heap(heap.begin(), heap.end());
  return heap;
}

}  // namespace homolog
