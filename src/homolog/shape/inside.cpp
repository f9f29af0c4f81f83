// SPDX-License-Identifier: MIT
#include "homolog/shape/inside.h"

#include <algorithm>

#include "homolog/shape/settle_by_winding.h"

namespace homolog {
namespace {

constexpr float agreement = 0.5f;  // rays of two axes sample the skin differently, but the inside of a voxel not by more than this
constexpr float most_lost = 0.5f;  // of a column's rays: beyond it, its axis has no vote

enum class Verdict : std::uint8_t { by_three, by_two, disputed };  ///< how many axes agree

struct Vote {
  float coverage;
  Verdict verdict;
};

Vote vote(const std::array<float, 3>& value, const std::array<float, 3>& lost) {
  float sum = 0, low = 2, high = -1;
  int votes = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (lost[axis] > most_lost) continue;
    ++votes;
    const float own = value[axis] / (1 - lost[axis]);
    sum += own;
    low = std::min(low, own);
    high = std::max(high, own);
  }
  if (votes < 2 || high - low > agreement) return {0, Verdict::disputed};
  return {sum / static_cast<float>(votes), votes == 3 ? Verdict::by_three : Verdict::by_two};
}

}  // namespace

Inside inside_of_closed(const GridSurface& surface) {
  AxisCoverage coverage{std::vector<float>(surface.voxels(), 0), {}};
  for (int axis = 0; axis < 3; ++axis) add_ray_coverage(surface, axis, coverage);
  for (float& value : coverage.sums) value /= 3.0f * full_coverage;
  return {std::move(coverage.sums), 0};
}

Inside inside_of_open(const GridSurface& surface) {
  std::array<AxisCoverage, 3> axes;
  for (int axis = 0; axis < 3; ++axis) {
    axes[axis].sums.assign(surface.voxels(), 0);
    add_ray_coverage(surface, axis, axes[axis]);
  }
  Inside result{std::vector<float>(surface.voxels()), 0};
  std::vector<Verdict> verdicts(surface.voxels());
  const std::size_t nx = surface.size[0], ny = surface.size[1];
  for (std::size_t i = 0; i < surface.voxels(); ++i) {
    const std::size_t x = i % nx, y = i / nx % ny, z = i / nx / ny;
    const Vote of_axes = vote({axes[0].sums[i] / full_coverage, axes[1].sums[i] / full_coverage, axes[2].sums[i] / full_coverage},
                              {axes[0].lost[y + z * ny], axes[1].lost[x + z * nx], axes[2].lost[x + y * nx]});
    result.coverage[i] = of_axes.coverage;
    verdicts[i] = of_axes.verdict;
  }
  std::vector<std::uint8_t> disputed(verdicts.size());
  bool vouched = false;  // winding numbers alone would fill the hollow side of any sheet
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    disputed[i] = verdicts[i] == Verdict::disputed;
    vouched = vouched || (!disputed[i] && result.coverage[i] > 0);
  }
  if (!vouched) return {std::vector<float>(surface.voxels(), 0), 0};
  settle_by_winding(surface, disputed, result.coverage);
  double inside = 0, guessed = 0;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    inside += result.coverage[i];
    if (verdicts[i] != Verdict::by_three) guessed += result.coverage[i];
  }
  if (inside > 0) result.guessed = guessed / inside;
  return result;
}

}  // namespace homolog
