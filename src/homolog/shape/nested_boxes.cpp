// SPDX-License-Identifier: MIT
// A grid for the boxes of every size, whose cells are two to four times as wide as they, so that a box lies in three of them in the mean.
// Cells of one number that are not the same do no harm.
#include "homolog/shape/nested_boxes.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace homolog {
namespace {

constexpr int wider = 2;  // as a power of two, than the smallest that has a box in at most eight cells

int size_of(const Box& box) {
  const double side = (box.max - box.min).maxCoeff();
  return side > 0 && std::isfinite(side) ? std::ilogb(side) : 0;
}

std::uint64_t cell_number(int size, const Vec3& cell) {
  std::uint64_t number = static_cast<std::uint64_t>(size);
  for (int axis = 0; axis < 3; ++axis) {
    number = (number ^ std::bit_cast<std::uint64_t>(cell[axis] + 0.0)) * 0x9e3779b97f4a7c15u;
    number ^= number >> 29;
  }
  return number;
}

Vec3 cell_of(const Vec3& place, int size) {
  return place.unaryExpr([&](double x) { return std::floor(std::ldexp(x, -(size + wider))); });
}

}  // namespace

NestedBoxes::NestedBoxes(const std::vector<Box>& boxes) {
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const int size = size_of(boxes[i]);
    sizes_.push_back(size);
    const Vec3 low = cell_of(boxes[i].min, size), high = cell_of(boxes[i].max, size);
    for (int corner = 0; corner < 8; ++corner) {
      Vec3 cell = low;
      bool is_new = true;
      for (int axis = 0; axis < 3; ++axis) {
        if (!(corner >> axis & 1)) continue;
        is_new &= high[axis] != low[axis];
        cell[axis] = high[axis];
      }
      if (is_new) cells_.emplace_back(cell_number(size, cell), i);
    }
  }
  std::sort(cells_.begin(), cells_.end());
  std::sort(sizes_.begin(), sizes_.end());
  sizes_.erase(std::unique(sizes_.begin(), sizes_.end()), sizes_.end());
}

std::vector<std::uint32_t> NestedBoxes::around(const Vec3& place) const {
  std::vector<std::uint32_t> numbers;
  for (const int size : sizes_) {
    const std::uint64_t cell = cell_number(size, cell_of(place, size));
    for (auto at = std::lower_bound(cells_.begin(), cells_.end(), std::pair(cell, 0u)); at != cells_.end() && at->first == cell; ++at) {
      numbers.push_back(at->second);
    }
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

}  // namespace homolog
