// SPDX-License-Identifier: MIT
// Places and weights are found in vectors; what they weigh is fetched one after the other.
#include "homolog/shape/many_samples.h"

#include <algorithm>
#include <cstdint>

#include "homolog/base/widest_clone.h"

namespace homolog {
namespace {

constexpr std::size_t at_once = 32;

/// For each of some places along an axis: the two voxels around it, by their numbers times `stride`, and what they weigh: nothing beyond
/// the grid.
struct Neighbours {
  std::int32_t first[at_once], step[at_once];
  float first_weight[at_once], second_weight[at_once];
};

[[gnu::always_inline]] inline void find_neighbours(double middle, double radius, const double* ways, int size, Neighbours& found) {
  for (std::size_t i = 0; i < at_once; ++i) {
    const double place = middle + radius * ways[i], not_low = place > -1 ? place : -1, within = not_low < size ? not_low : size;
    const auto low = static_cast<std::int32_t>(within + 1) - 1;
    const auto share = static_cast<float>(within - low);
    found.first[i] = low < 0 ? 0 : low < size ? low : size - 1;
    found.step[i] = low >= 0 && low + 1 < size ? 1 : 0;
    found.first_weight[i] = low >= 0 && low < size ? 1 - share : 0;
    found.second_weight[i] = low + 1 < size ? share : 0;
  }
}

}  // namespace

VectorColumns::VectorColumns(const std::vector<Vec3>& vectors) {
  const std::size_t padded = (vectors.size() + at_once - 1) / at_once * at_once;
  for (auto* column : {&x, &y, &z}) column->reserve(padded);
  for (const Vec3& vector : vectors) {
    x.push_back(vector.x());
    y.push_back(vector.y());
    z.push_back(vector.z());
  }
  for (auto* column : {&x, &y, &z}) column->resize(padded);
}

HOMOLOG_WIDEST_CLONE void add_samples(const Volume<float>& volume, const Vec3& middle, double radius, const VectorColumns& ways,
                                      float* sums) {
  const auto& [nx, ny, nz] = volume.frame.size;
  Neighbours x, y, z;
  for (std::size_t begin = 0; begin < ways.x.size(); begin += at_once) {
    find_neighbours(middle.x(), radius, &ways.x[begin], nx, x);
    find_neighbours(middle.y(), radius, &ways.y[begin], ny, y);
    find_neighbours(middle.z(), radius, &ways.z[begin], nz, z);
    for (std::size_t i = 0; i < at_once; ++i) {
      const std::ptrdiff_t row = nx, slice = row * ny, dx = x.step[i], dy = y.step[i] * row, dz = z.step[i] * slice;
      const float* at = volume.values.data() + z.first[i] * slice + y.first[i] * row + x.first[i];
      const auto along_x = [&](const float* pair) { return x.first_weight[i] * pair[0] + x.second_weight[i] * pair[dx]; };
      const auto along_y = [&](const float* four) { return y.first_weight[i] * along_x(four) + y.second_weight[i] * along_x(four + dy); };
      sums[begin + i] += z.first_weight[i] * along_y(at) + z.second_weight[i] * along_y(at + dz);
    }
  }
}

}  // namespace homolog
